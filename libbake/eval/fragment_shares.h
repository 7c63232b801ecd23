// Which fragments show under the blocks of a scale's levels of detail, and how much of each block they are: what takes
// colours of the coarser scale there.
// Based on: Vanhoey et al. 2013, eq. 5, averaged over a block.
#pragma once

#include "libbake/eval/level_lists.h"
#include "libbake/eval/stack_planes.h"

namespace texbake {

struct FragmentShares {
  Image<glsl::FragmentRange> ranges;  ///< of each value of a level: the same numbers, the same rows
  std::vector<glsl::ivec4> shares;  ///< centre x, y from the corner of the block's repetition; bits of the float share
                                    ///< times the share taken; the centre's texel of the tile, x + 65536 y
};

/// Of levels 1 … `last_level`. `planes` are those of the scale alone, `lists` theirs.
FragmentShares fragment_shares(const StackScale& scale, const EvaluatorPlanes& planes, const LevelLists& lists,
                               int last_level);

}  // namespace texbake
