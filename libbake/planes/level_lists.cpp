#include "libbake/planes/level_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "libbake/base/error.h"
#include "libbake/planes/level_grid.h"

namespace texbake {
namespace {

using glsl::LevelBlock;
using glsl::PatchTexel;

constexpr uint32_t kMaxEntriesInBlock = 1u << (32 - glsl::kBlockFollowingBit);  ///< what LevelBlock can count

bool too_crowded(const LevelCover& cover) {
  for (size_t i = 0; i + 1 < cover.first.size(); ++i)
    if (cover.first[i + 1] - cover.first[i] > kMaxEntriesInBlock) return true;
  return false;
}

/// Numbers the entries of blocks that have at least `least`.
void number(LevelList& list, uint32_t least, uint64_t& count) {
  for (size_t i = 0; i + 1 < list.cover.first.size(); ++i) {
    const uint32_t entries = list.cover.first[i + 1] - list.cover.first[i];
    list.first.push_back(entries >= least ? static_cast<uint32_t>(count) : 0);
    if (entries >= least) count += entries;
  }
}

LevelList texel_list(const TilePlanes& planes, LevelLists& lists) {
  LevelList list;
  if (planes.soft_border_px > 0) {
    SoftCover soft = soft_cover(planes.patch_plane, planes.soft_border_px);
    list.cover = std::move(soft.cover);
    lists.weights = std::move(soft.weights);
    list.corner = {0, 0};
  } else {
    list.cover = texel_cover(planes.patch_plane);
  }
  number(list, 2, lists.count);
  return list;
}

bool consists_of(V2i blocks, V2i finer) { return finer.x % blocks.x == 0 && finer.y % blocks.y == 0; }

LevelList coarser_list(const std::vector<LevelList>& lists, V2i blocks) {
  LevelList list;
  list.finer = lists.size() - 1;
  while (!consists_of(blocks, lists[list.finer].cover.size)) --list.finer;
  list.cover = coarsened(lists[list.finer].cover, blocks);
  return list;
}

/// On shelves as wide as the tile, one list beside the other; texels first.
int place(std::vector<LevelList>& lists, V2i tile_size) {
  int x = 0, y = lists[0].corner.x == 0 ? tile_size.y : 0, shelf = 0;
  for (size_t i = 1; i < lists.size(); ++i) {
    const V2i size = lists[i].cover.size;
    if (x + size.x > tile_size.x) {
      y += shelf;
      x = shelf = 0;
    }
    lists[i].corner = {x, y};
    x += size.x;
    shelf = std::max(shelf, size.y);
  }
  return y + shelf;
}

void check_count(const LevelLists& lists, int content_count) {
  const uint64_t values = lists.count * static_cast<uint64_t>(content_count);
  if (values > std::numeric_limits<uint32_t>::max())
    throw Error(ErrorKind::infeasible,
                fmt::format("levels of detail: expected fewer than 2^32 values, found {}: {} block shares with {} "
                            "contents each; use a smaller tile or fewer contents",
                            values, lists.count, content_count));
}

LevelBlock block_of(uint32_t first, std::span<const PatchTexel> entries) {
  const uint32_t owned = entries[0].patch_idx | static_cast<uint32_t>(entries[0].owner) << glsl::kBlockOwnerBit;
  return {first, owned | static_cast<uint32_t>(entries.size() - 1) << glsl::kBlockFollowingBit};
}

void store_list(const LevelList& list, LevelTables& tables) {
  if (list.corner.x < 0) return;
  for (int y = 0; y < list.cover.size.y; ++y)
    for (int x = 0; x < list.cover.size.x; ++x) {
      const uint32_t first = list.first_at({x, y});
      const auto entries = list.cover.at(x, y);
      tables.level_blocks(list.corner.x + x, list.corner.y + y) = block_of(first, entries);
      if (first > 0) std::copy(entries.begin(), entries.end(), tables.level_entries.begin() + first);
    }
}

/// The level of the noises whose blocks have about as many texels: 4^level, at most twice as many or few; −1 where they
/// have none so large.
int noise_level_of(V2i block_side, const glsl::ivec2& noise_log2) {
  const int64_t texels = int64_t{block_side.x} * block_side.y;
  for (int level = 0; level <= noise_log2.y; ++level)
    if (texels < int64_t{2} << (2 * level)) return level;
  return -1;
}

/// log2 of a power of two, 0 of other numbers.
int shift_of(int n) {
  const auto bits = static_cast<uint32_t>(n);
  return std::has_single_bit(bits) ? std::countr_zero(bits) : 0;
}

}  // namespace

LevelLists level_lists(const TilePlanes& planes) {
  LevelLists lists;
  lists.lists.push_back(texel_list(planes, lists));
  const std::vector<V2i> grids = level_grids(planes.size);
  lists.list_of_level.push_back(0);
  for (size_t level = 1; level < grids.size(); ++level) {
    if (grids[level] != grids[level - 1]) {
      LevelList list = coarser_list(lists.lists, grids[level]);
      if (too_crowded(list.cover)) break;
      number(list, 1, lists.count);
      lists.lists.push_back(std::move(list));
    }
    lists.list_of_level.push_back(lists.lists.size() - 1);
  }
  check_count(lists, planes.content_count);
  lists.block_rows = place(lists.lists, planes.size);
  return lists;
}

LevelTables level_tables(const LevelLists& lists, const TilePlanes& planes) {
  LevelTables tables;
  tables.level_count = lists.level_count();
  tables.first_level = planes.soft_border_px > 0 ? 0 : 1;
  tables.level_blocks = Image<LevelBlock>(planes.size.x, std::max(lists.block_rows, 1));
  tables.level_entries = Image<PatchTexel>(kListWidth, list_rows(lists.count));
  for (const LevelList& list : lists.lists) store_list(list, tables);
  tables.level_table = Image<glsl::ivec4>(3, tables.level_count + 1, {0, 0, 0, 0});
  for (int level = 0; level <= tables.level_count; ++level) {
    const size_t at = lists.list_of_level[static_cast<size_t>(level)];
    const V2i blocks = lists.lists[at].cover.size;
    // Without entries of its own, level 0 is where the text draws it from.
    const V2i corner = at == 0 ? V2i(-1) : lists.lists[at].corner;
    const V2i side(planes.size.x / blocks.x, planes.size.y / blocks.y);
    const V2i side_256 = side * 256;
    tables.level_table(0, level) = {blocks.x, blocks.y, corner.x, corner.y};
    tables.level_table(1, level) = {side_256.x, side_256.y, shift_of(side_256.x), shift_of(side_256.y)};
    tables.level_table(2, level) = {noise_level_of(side, planes.noise_log2), 0, 0, 0};
  }
  return tables;
}

}  // namespace texbake
