// Which fragments show under the blocks of a scale's levels of detail, and how much of each block they are: what takes
// colors of the coarser scale there.
// Based on: Vanhoey et al. 2013, eq. 5, averaged over a block.
#pragma once

#include "libbake/planes/level_lists.h"
#include "libbake/planes/stack_scale.h"

namespace texbake {

/// Of levels 1 … `last_level` and of texels on soft borders, as fragment_shares of shaders/stack_bindings.glsl: first
/// those that come first under a value of a block, at that value's number, then the others, as wide. (center x + 65536
/// y from the corner of the block's repetition, 16 bits each; bits of the float share of the block times the share
/// taken; texel of the tile that shows at the center, x + 65536 y; number of the next one, 0 for none.) `planes` are
/// those of the scale alone, `lists` theirs.
Image<glsl::ivec4> fragment_shares(const StackScale& scale, const TilePlanes& planes, const LevelLists& lists,
                                   int last_level);

}  // namespace texbake
