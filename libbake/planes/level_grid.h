// How each level of detail cuts the tile into blocks.
#pragma once

#include <vector>

#include "libbake/base/torus.h"

namespace texbake {

/// Blocks of a level on each axis. Level 0 has texels. Level l halves those of the level before where that leaves
/// 2^l texels a side; where it does not, or sides differ, an axis has the fewest blocks, a power of two that divides
/// it, whose sides are at most √2 · 2^l; where there is none so small, as many as the level before. The last level is
/// the first that has one block: the tile.
std::vector<V2i> level_grids(V2i tile_size);

}  // namespace texbake
