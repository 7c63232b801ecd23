// Gaussian low-pass of large pictures at a reduced size: wide Gaussians need no more texels.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// The largest power of two that divides both sides of `size` and leaves the Gaussian at least two reduced texels
/// wide: beyond their Nyquist frequency it lets less than 1e-8 through.
int reduction_factor(V2i size, double sigma_px);

/// The means of factor × factor blocks. `factor` ≥ 1 divides both sides.
Image<V3f> reduce(ImageView<const V3f> image, int factor);

/// The picture averaged over factor × factor blocks, then smoothed on the torus so that block and Gaussian together
/// have the variance sigma². `factor` ≥ 1 divides both sides.
Image<V3f> low_pass(ImageView<const V3f> image, double sigma_px, int factor);

}  // namespace texbake
