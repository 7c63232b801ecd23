// The principal variation color space: K dominant colors, each with one direction of variation.
// Based on: Vanhoey et al. 2013, §4, eq. 1.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// One color class. Colors of the class are C = dominant + v · variation, in CIELUV (D65, L in 0 … 100).
struct ColorClass {
  V3f dominant{0};   ///< D_i, the mean of the class: (L, u*, v*)
  V3f variation{0};  ///< V_i, a unit vector; its component of largest magnitude is positive
};

struct Palette {
  std::vector<ColorClass> classes;  ///< 1 … kMaxClasses, ordered by dominant L, dark first
};
inline constexpr int kMaxClasses = 64;

/// An exemplar in its principal variation color space.
struct PrincipalVariation {
  Palette palette;
  Image<uint8_t> index;    ///< class of each texel, 0 … K−1
  Image<float> variation;  ///< coordinate v along V_i in ΔE units, half-exact
};

/// The color that (index, variation) stands for, linear Rec.709: the paper's compact form. Channels that would be
/// negative are 0.
Image<V3f> decode(const PrincipalVariation& colors);
/// The dominant part alone: D_i of each texel, linear Rec.709.
Image<V3f> decode_dominant(const PrincipalVariation& colors);

}  // namespace texbake
