// The color space of one noise: the principal axes of its colors, in which its channels are as independent as they
// can be. Based on: Guingo et al. 2017, §6.
#pragma once

#include <array>
#include <cstdint>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Orthonormal axes in linear Rec.709: color = mean + Σ channel_c · axis[c].
struct ColorBasis {
  V3f mean{0};
  std::array<V3f, 3> axis = {V3f(1, 0, 0), V3f(0, 1, 0), V3f(0, 0, 1)};

  V3f channels(const V3f& color) const {
    const V3f d = color - mean;
    return {d.dot(axis[0]), d.dot(axis[1]), d.dot(axis[2])};
  }
  V3f color(const V3f& channels) const {
    return mean + axis[0] * channels.x + axis[1] * channels.y + axis[2] * channels.z;
  }
};

/// Principal axes of the colors where `mask` is not 0, by falling variance; the component of largest magnitude of each
/// axis is positive. Without any color variation the axes are R, G, B.
ColorBasis principal_basis(ImageView<const V3f> colors, ImageView<const uint8_t> mask);

/// The axes of `basis` reordered and turned so that axis c is the one nearest to `reference.axis[c]`: greatest sum of
/// |dot products|, each dot product ≥ 0. Blends of two noises then blend like with like.
ColorBasis match_axes(const ColorBasis& basis, const ColorBasis& reference);

}  // namespace texbake
