// How far levels of detail are from the box means of the infinite texture: those of this library beside two that other
// implementations draw.
#pragma once

#include <vector>

#include "libbake/eval/prepare.h"

namespace texbake {

/// Differences of blocks from the box means of their texels, over all blocks and colour channels, in units of the
/// values.
struct LevelError {
  double signed_mean = 0;  ///< below 0: darker
  double mean = 0;         ///< of magnitudes
  double worst = 0;
};

struct LevelBias {
  int level = 1;
  LevelError unbiased;   ///< shares of patches, as add_levels makes them
  LevelError cheap;      ///< box means of the tile, read where the content of a block's centre says
  LevelError truncated;  ///< box means of box means, each rounded down to a 255th, as 8-bit mip chains are made
};

/// Levels 1 … of `plane`, whose levels were added, while both sides are halved, over `repetitions` × `repetitions` of
/// the tile.
std::vector<LevelBias> level_biases(const EvaluatorPlanes& planes, const Plane& plane, uint32_t seed, int repetitions);

}  // namespace texbake
