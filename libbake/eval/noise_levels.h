// Levels of detail of the noises: what is left of a grain in blocks of texels. Based on: Guingo et al. 2017, §6: a mean
// over a block fades the high frequencies of the spectrum, and what is left is a Gaussian noise once more.
#pragma once

#include "libbake/base/image.h"
#include "libbake/eval/glsl.h"

namespace texbake {

/// Fills what lies right of the noise of `size` × `size` texels, a power of two, at (0, first_row) of `noise_tiles`,
/// which is 3/2 · size wide: level l = 1 … log2(size) has size / 2^l blocks a side, level 1 on top, the next below it.
/// A block is the mean of its texels without that of the whole noise, in double, rounded to half.
void fill_noise_levels(Image<glsl::vec4>& noise_tiles, int size, int first_row);

}  // namespace texbake
