// How a height map looks under a light, for the eye that judges it.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// A depth at which the relief of a usual tile is seen well, for previews.
inline constexpr float kPreviewDepthPx = 16;

/// The tile, `base` in linear light, lit from the upper left at 45 degrees as if its surface rose by `depth_px` texels
/// from height 0 to 1: Lambert's cosine over that of a flat surface, normals from central differences on the torus.
/// A flat height gives the base unchanged.
Image<V3f> shaded(ImageView<const V3f> base, ImageView<const float> height_01, float depth_px);

/// Pearson's correlation of two images of one size, in −1 … 1; 0 where one of them is constant.
double correlation(ImageView<const float> a, ImageView<const float> b);

}  // namespace texbake
