// The weights of noises in levels of detail: how much of each noise a patch's content shows in a block.
#pragma once

#include "libbake/planes/level_lists.h"

namespace texbake {

/// The weights of noises in every share of `lists`, in the layout of values (level_shares.h): means of the masks, 0 … 1
/// and premultiplied by the patch's cover and by what `planes` have the noise multiplied with, in 1/2048, rounded to
/// the nearest, so that those of a block may miss 2048 by a step for each share. A texel has the weights of its own
/// patch, even where borders are soft. `planes` have noises.
Image<glsl::MaskTexel> level_weights(const TilePlanes& planes, const LevelLists& lists);

}  // namespace texbake
