// The weights of noises in levels of detail: how much of each noise a patch's content shows in a block.
#pragma once

#include "libbake/eval/level_lists.h"

namespace texbake {

/// Means of the masks in every share of `lists`, 0 … 1 and premultiplied by the patch's cover, in the layout of values
/// (level_shares.h). A texel has the weights of its own patch, even where borders are soft. `planes` have noises.
Image<glsl::vec4> level_weights(const EvaluatorPlanes& planes, const LevelLists& lists);

/// The same in 1/2048, rounded to the nearest: those of a block may miss 2048 by a step for each share. As they are
/// bound.
Image<glsl::MaskTexel> in_steps(const Image<glsl::vec4>& weights);

/// Adds to every share, and to the mean, the means of the noises times its weights.
void add_noise_means(const EvaluatorPlanes& planes, const Image<glsl::vec4>& weights, Image<glsl::vec4>& values);

}  // namespace texbake
