#include "libbake/height/shading.h"

#include <algorithm>
#include <cmath>

namespace texbake {

Image<V3f> shaded(ImageView<const V3f> base, ImageView<const float> height_01, float depth_px) {
  const int width = base.width(), height = base.height();
  const V3f light = V3f(-1, -1, std::sqrt(2.0f)).normalized();
  Image<V3f> lit(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float dx = height_01(wrap(x + 1, width), y) - height_01(wrap(x - 1, width), y);
      const float dy = height_01(x, wrap(y + 1, height)) - height_01(x, wrap(y - 1, height));
      const V3f normal = V3f(-0.5f * depth_px * dx, -0.5f * depth_px * dy, 1).normalized();
      lit(x, y) = base(x, y) * (std::max(0.0f, normal.dot(light)) / light.z);
    }
  return lit;
}

double correlation(ImageView<const float> a, ImageView<const float> b) {
  double sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const double u = a(x, y), v = b(x, y);
      sum_a += u, sum_b += v, sum_aa += u * u, sum_bb += v * v, sum_ab += u * v;
    }
  const auto count = static_cast<double>(a.size());
  const double spread =
      (sum_aa / count - sum_a * sum_a / count / count) * (sum_bb / count - sum_b * sum_b / count / count);
  constexpr double kConstant = 1e-18;  // what rounding leaves of the spread of a constant
  return spread > kConstant ? (sum_ab / count - sum_a * sum_b / count / count) / std::sqrt(spread) : 0;
}

}  // namespace texbake
