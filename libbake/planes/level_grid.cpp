#include "libbake/planes/level_grid.h"

#include <cstdint>

namespace texbake {
namespace {

/// Blocks of level `level` along `side` texels, `before` being those of the level before.
int blocks_of(int side, int level, int before) {
  if (before * (1 << (level - 1)) == side && before % 2 == 0) return before / 2;
  const int64_t widest_squared = int64_t{2} << (2 * level);
  for (int blocks = 1; side % blocks == 0; blocks *= 2) {
    const int64_t width = side / blocks;
    if (width * width <= widest_squared) return blocks < before ? blocks : before;
  }
  return before;
}

}  // namespace

std::vector<V2i> level_grids(V2i tile_size) {
  std::vector<V2i> grids = {tile_size};
  while (grids.back() != V2i(1)) {
    const int level = static_cast<int>(grids.size());
    grids.emplace_back(blocks_of(tile_size.x, level, grids.back().x), blocks_of(tile_size.y, level, grids.back().y));
  }
  return grids;
}

}  // namespace texbake
