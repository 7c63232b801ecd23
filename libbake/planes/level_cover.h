// Which patches lie under the blocks of each level of detail.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/reference/glsl.h"

namespace texbake {

/// The patches under every block of one level, each with the owner offset at the block: one entry for each.
struct LevelCover {
  V2i size{0, 0};                         ///< blocks
  std::vector<uint32_t> first;            ///< of each block in row order, and the number of entries at the end
  std::vector<glsl::PatchTexel> entries;  ///< of a block: in the order of its first texels

  std::span<const glsl::PatchTexel> at(int x, int y) const {
    const size_t block = static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x);
    return {entries.data() + first[block], entries.data() + first[block + 1]};
  }
  uint32_t first_at(int x, int y) const {
    return first[static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)];
  }
};

/// Level 0: one patch for each texel.
LevelCover texel_cover(ImageView<const glsl::PatchTexel> patch_plane);

/// A coarser level of `size` blocks, which divide those of `finer`.
LevelCover coarsened(const LevelCover& finer, V2i size);

}  // namespace texbake
