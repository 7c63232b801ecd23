#include "libbake/height/descriptor.h"

#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

// G_σ∗(v·1_class) / G_σ∗1_class; 0 where no texel of the class is within reach.
Image<float> smoothed_in_class(const Image<float>& values, const Image<float>& members, double sigma_px) {
  Image<float> sum = gaussian_blur(values, sigma_px, Wrap::repeat);
  const Image<float> weight = gaussian_blur(members, sigma_px, Wrap::repeat);
  for (size_t i = 0; i < sum.size(); ++i) {
    const float w = weight.data()[i];
    sum.data()[i] = w > 1e-6f ? sum.data()[i] / w : 0.0f;
  }
  return sum;
}

Image<V2f> central_differences(const Image<float>& image) {
  const int width = image.width();
  const int height = image.height();
  Image<V2f> gradient(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      gradient(x, y) = V2f(image(wrap(x + 1, width), y) - image(wrap(x - 1, width), y),
                           image(x, wrap(y + 1, height)) - image(x, wrap(y - 1, height))) *
                       0.5f;
  return gradient;
}

}  // namespace

float descriptor_distance(const float* a, const float* b) {
  // Eight independent sums, so that the loop vectorizes without changing the order of additions.
  float sums[8] = {};
  int i = 0;
  for (; i + 8 <= kDescriptorGradients; i += 8)
    for (int lane = 0; lane < 8; ++lane) {
      const float dx = a[2 * (i + lane)] - b[2 * (i + lane)];
      const float dy = a[2 * (i + lane) + 1] - b[2 * (i + lane) + 1];
      sums[lane] += std::sqrt(dx * dx + dy * dy);
    }
  float rest = 0.0f;
  for (; i < kDescriptorGradients; ++i) {
    const float dx = a[2 * i] - b[2 * i];
    const float dy = a[2 * i + 1] - b[2 * i + 1];
    rest += std::sqrt(dx * dx + dy * dy);
  }
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7])) + rest;
}

ClassGradients::ClassGradients(const PrincipalVariation& colors, uint8_t class_idx) {
  Image<float> members(colors.index.width(), colors.index.height());
  Image<float> values(colors.index.width(), colors.index.height());
  for (size_t i = 0; i < members.size(); ++i) {
    const bool inside = colors.index.data()[i] == class_idx;
    members.data()[i] = inside ? 1.0f : 0.0f;
    values.data()[i] = inside ? colors.variation.data()[i] : 0.0f;
  }
  for (int sigma = 1; sigma <= kDescriptorScales; ++sigma)
    gradients_.push_back(central_differences(smoothed_in_class(values, members, sigma)));
}

V2f ClassGradients::gradient(int scale, V2f position) const {
  const Image<V2f>& image = gradients_[static_cast<size_t>(scale)];
  const float floor_x = std::floor(position.x);
  const float floor_y = std::floor(position.y);
  const int x0 = wrap(static_cast<int>(floor_x), image.width());
  const int y0 = wrap(static_cast<int>(floor_y), image.height());
  const int x1 = wrap(x0 + 1, image.width());
  const int y1 = wrap(y0 + 1, image.height());
  const float wx = position.x - floor_x;
  const float wy = position.y - floor_y;
  const V2f top = image(x0, y0) + (image(x1, y0) - image(x0, y0)) * wx;
  const V2f bottom = image(x0, y1) + (image(x1, y1) - image(x0, y1)) * wx;
  return top + (bottom - top) * wy;
}

Descriptor ClassGradients::at(V2i texel) const {
  const V2i size(gradients_[0].width(), gradients_[0].height());
  Descriptor descriptor;
  size_t i = 0;
  for (const Image<V2f>& image : gradients_)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const V2i p = wrap(texel + V2i(dx, dy), size);
        const V2f& g = image(p.x, p.y);
        descriptor[i++] = g.x;
        descriptor[i++] = g.y;
      }
  return descriptor;
}

Descriptor ClassGradients::turned(V2i texel, double angle_rad) const {
  const auto c = static_cast<float>(portable_cos(angle_rad));
  const auto s = static_cast<float>(portable_sin(angle_rad));
  Descriptor descriptor;
  size_t i = 0;
  for (int scale = 0; scale < kDescriptorScales; ++scale)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        // What stands at offset d after the turn stood at R(−angle) d before; its gradient turns along.
        const auto fx = static_cast<float>(dx);
        const auto fy = static_cast<float>(dy);
        const V2f position(static_cast<float>(texel.x) + c * fx + s * fy,
                           static_cast<float>(texel.y) - s * fx + c * fy);
        const V2f g = gradient(scale, position);
        descriptor[i++] = c * g.x - s * g.y;
        descriptor[i++] = s * g.x + c * g.y;
      }
  return descriptor;
}

}  // namespace texbake
