// In what noise is added to a structure. Based on: Guingo et al. 2017, eq. 6, whose pictures hold codes for display.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/options.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Grain of a surface is stronger where that is lighter, and skew: drawn anew from a histogram and added to light it
/// leaves specks on dark ground. In the square root of light, which is near what displays are given, it is neither.
enum class NoiseSpace {
  root,    ///< light = (√structure + noise)²
  linear,  ///< light = structure + noise
};
template <>
struct EnumNames<NoiseSpace> {
  static constexpr std::pair<NoiseSpace, std::string_view> values[] = {{NoiseSpace::root, "root"},
                                                                       {NoiseSpace::linear, "linear"}};
};

/// The square root of each channel, 0 where that is below 0.
Imath::V3d roots(const Imath::V3d& light);

/// Light, linear Rec.709, in that space; its root is 0 where it is below 0.
Image<V3f> in_noise_space(ImageView<const V3f> light, NoiseSpace space);

/// The light of what is in that space.
Image<V3f> to_light(ImageView<const V3f> values, NoiseSpace space);

}  // namespace texbake
