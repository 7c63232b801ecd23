// How the surroundings of a texel look, at five widths: what tells similar places apart better than gradients alone.
// Measured against photographs with known heights: their heights follow smoothed color and its local deviation.
#pragma once

#include <array>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

inline constexpr std::array<int, 5> kAppearanceSigmas_px = {1, 2, 4, 8, 16};

/// For each σ twelve numbers in ΔE: the Gaussian mean of the color, its deviation (channel by channel), and σ times
/// the mean's gradient along x and along y.
using Appearance = std::array<float, 12 * kAppearanceSigmas_px.size()>;

/// Σ over σ of the lengths of the differences of mean, deviation and gradient.
float appearance_distance(const float* a, const float* b);

/// Means and deviations of a tile, which is a torus.
class AppearancePyramid {
 public:
  explicit AppearancePyramid(ImageView<const V3f> luv);

  Appearance at(V2i texel) const;

 private:
  struct Level {
    Image<V3f> mean;
    Image<V3f> deviation;
  };
  std::vector<Level> levels_;  ///< one for each σ
};

}  // namespace texbake
