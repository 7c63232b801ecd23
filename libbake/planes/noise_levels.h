// Levels of detail of the noises: what is left of a grain in blocks of texels. Based on: Guingo et al. 2017, §6: a mean
// over a block fades the high frequencies of the spectrum, and what is left is a Gaussian noise once more.
#pragma once

#include <functional>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/reference/glsl.h"

namespace texbake {

/// The values of a noise in reading order, width and height powers of two, become those of its box means over 2 × 2
/// texels: half as many rows (of one row half the width), with the same `row_step` (NoiseInput).
Image<Imath::V3d> halved_noise(const Image<Imath::V3d>& finer, int row_step);

/// Of which noise levels are made, and how.
struct NoiseLevels {
  V2i size;         ///< powers of two
  int row_step;     ///< as in NoiseInput
  bool keeps_mean;  ///< that of the whole noise, which is else taken away
};

/// Fills one of the columns right of the noise at (0, first.y) of `noise_tiles`, from texel first.x on: level
/// l = 1 … log2(size.y) has size.y / 2^l rows, level 1 on top, the next below it. A value is the mean over a block of
/// texels of `value(v)`, in double, rounded to half.
void fill_noise_levels(Image<glsl::vec4>& noise_tiles, const NoiseLevels& of, V2i first,
                       const std::function<Imath::V3d(const Imath::V3d&)>& value);

}  // namespace texbake
