// The weights of noises in levels of detail: how much of each noise a patch's content shows in a block.
#pragma once

#include "libbake/planes/level_lists.h"

namespace texbake {

/// Means of the masks in every share of `lists`, 0 … 1 and premultiplied by the patch's cover and by what `planes` have
/// the noise multiplied with, in the layout of values (level_shares.h). A texel has the weights of its own patch, even
/// where borders are soft. `planes` have noises.
Image<glsl::vec4> level_weights(const EvaluatorPlanes& planes, const LevelLists& lists);

/// The same in 1/2048, rounded to the nearest: those of a block may miss 2048 by a step for each share. As they are
/// bound.
Image<glsl::MaskTexel> in_steps(const Image<glsl::vec4>& weights);

/// Sets those of the texels that are several patches' where borders are soft. They are drawn
/// as texels are.
void add_texel_weights(const EvaluatorPlanes& planes, const LevelLists& lists, Image<glsl::vec4>& weights);

}  // namespace texbake
