// Gaussian low-pass of large pictures at a reduced size: wide Gaussians need no more texels.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// The largest power of two that divides both sides of `size` and leaves the Gaussian at least four reduced texels
/// wide.
int reduction_factor(V2i size, double sigma_px);

/// The picture averaged over factor × factor blocks, then smoothed on the torus so that block and Gaussian together
/// have the variance sigma². `factor` ≥ 1 divides both sides.
Image<V3f> low_pass(ImageView<const V3f> image, double sigma_px, int factor);

}  // namespace texbake
