// Gaussian smoothing with a fixed order of operations: the same bits on every processor, which OpenCV's does not give.
#pragma once

#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// What lies beyond the border of an image.
enum class Wrap {
  repeat,  ///< the image again: a torus
  clamp,   ///< the nearest border texel
};

/// Weights exp(−d²/2σ²) for d = −r … r with r = ceil(3σ), sum 1. σ = 0 gives the single weight 1.
std::vector<float> gaussian_kernel(double sigma_px);

/// Separable Gaussian of standard deviation `sigma_px` ≥ 0, horizontal pass first.
Image<float> gaussian_blur(ImageView<const float> image, double sigma_px, Wrap wrap);
Image<V3f> gaussian_blur(ImageView<const V3f> image, double sigma_px, Wrap wrap);

}  // namespace texbake
