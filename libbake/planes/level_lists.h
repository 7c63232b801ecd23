// Which patches lie under the blocks of each level of detail, in one list of entries, and where each level's blocks
// are.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/planes/evaluator_planes.h"
#include "libbake/planes/level_cover.h"
#include "libbake/planes/soft_cover.h"

namespace texbake {

/// Blocks of one size with their entries; several levels may share them.
struct LevelList {
  LevelCover cover;
  std::vector<uint32_t> first;  ///< number of each block's first entry in the list of all; 0 where it has none
  V2i corner{-1, -1};           ///< in level_blocks; −1 where it is not there
  size_t finer = 0;             ///< the coarsest list before it whose blocks its blocks consist of

  uint32_t first_at(V2i block) const {
    return first[static_cast<size_t>(block.y) * static_cast<size_t>(cover.size.x) + static_cast<size_t>(block.x)];
  }
};

/// List 0 is that of texels: they have entries where borders are soft and several patches count. Entry 0 of the whole
/// is kept for the mean.
struct LevelLists {
  std::vector<LevelList> lists;
  std::vector<size_t> list_of_level;  ///< of level 0, 1, …
  std::vector<float> weights;         ///< of the entries of list 0's cover; empty where borders are hard
  uint64_t count = 1;                 ///< entries in all
  int block_rows = 0;                 ///< of level_blocks, which is as wide as the tile

  int level_count() const { return static_cast<int>(list_of_level.size()) - 1; }
};

/// Reads patch_plane and soft_border_px of `planes`. Levels end before one with more than 4096 patches under a block.
/// Throws Error(infeasible) when there are 2^32 values or more.
LevelLists level_lists(const TilePlanes& planes);

/// The same as the evaluator reads it.
LevelTables level_tables(const LevelLists& lists, const TilePlanes& planes);

/// Texels in a row of level_entries and of values.
inline constexpr int kListWidth = glsl::kListWidth;
inline int list_rows(uint64_t count) { return static_cast<int>((count + kListWidth - 1) / kListWidth); }

}  // namespace texbake
