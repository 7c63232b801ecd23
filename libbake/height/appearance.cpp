#include "libbake/height/appearance.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/gaussian.h"

namespace texbake {
namespace {

V3f mean_color(ImageView<const V3f> luv) {
  Imath::V3d sum(0);
  for (int y = 0; y < luv.height(); ++y)
    for (int x = 0; x < luv.width(); ++x) sum += Imath::V3d(luv(x, y));
  return V3f(sum / static_cast<double>(luv.size()));
}

// sqrt(G_σ∗c² − (G_σ∗c)²), channel by channel.
Image<V3f> deviation_of(const Image<V3f>& mean, Image<V3f> mean_square) {
  for (size_t i = 0; i < mean.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const float m = mean.data()[i][c];
      float& square = mean_square.data()[i][c];
      square = std::sqrt(std::max(0.0f, square - m * m));
    }
  return mean_square;
}

template <int kCount>
float length_of_difference(const float* a, const float* b) {
  float sum = 0.0f;
  for (int i = 0; i < kCount; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

float* put(float* out, const V3f& value) {
  for (int c = 0; c < 3; ++c) *out++ = value[c];
  return out;
}

}  // namespace

float appearance_distance(const float* a, const float* b) {
  float sum = 0.0f;
  for (size_t level = 0; level < kAppearanceSigmas_px.size(); ++level, a += 12, b += 12)
    sum +=
        length_of_difference<3>(a, b) + length_of_difference<3>(a + 3, b + 3) + length_of_difference<6>(a + 6, b + 6);
  return sum;
}

AppearancePyramid::AppearancePyramid(ImageView<const V3f> luv) {
  // Colors less their mean, so that the difference of squares loses few digits.
  const V3f middle = mean_color(luv);
  Image<V3f> colors(luv.width(), luv.height());
  Image<V3f> squares(luv.width(), luv.height());
  for (int y = 0; y < luv.height(); ++y)
    for (int x = 0; x < luv.width(); ++x) {
      colors(x, y) = luv(x, y) - middle;
      squares(x, y) = colors(x, y) * colors(x, y);
    }
  for (const int sigma_px : kAppearanceSigmas_px) {
    Image<V3f> mean = gaussian_blur(colors, sigma_px, Wrap::repeat);
    Image<V3f> deviation = deviation_of(mean, gaussian_blur(squares, sigma_px, Wrap::repeat));
    levels_.push_back({std::move(mean), std::move(deviation)});
  }
}

Appearance AppearancePyramid::at(V2i texel) const {
  Appearance appearance;
  float* out = appearance.data();
  for (size_t i = 0; i < levels_.size(); ++i) {
    const Image<V3f>& mean = levels_[i].mean;
    const int left = wrap(texel.x - 1, mean.width()), right = wrap(texel.x + 1, mean.width());
    const int above = wrap(texel.y - 1, mean.height()), below = wrap(texel.y + 1, mean.height());
    const float per_step = 0.5f * static_cast<float>(kAppearanceSigmas_px[i]);
    out = put(out, mean(texel.x, texel.y));
    out = put(out, levels_[i].deviation(texel.x, texel.y));
    out = put(out, (mean(right, texel.y) - mean(left, texel.y)) * per_step);
    out = put(out, (mean(texel.x, below) - mean(texel.x, above)) * per_step);
  }
  return appearance;
}

}  // namespace texbake
