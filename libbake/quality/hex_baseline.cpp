// The plane is a grid of triangles; each corner owns a random shift of the exemplar, and a texel blends the three
// corners of its triangle by its barycentric coordinates.
#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/base/random.h"
#include "libbake/quality/baselines.h"

namespace texbake {
namespace {

constexpr double kContrast = 0.6;  // how much brightness enters the weights: the article's default

// The sharpened weight: exponent 7, the article's default.
double sharpened(double barycentric) {
  const double squared = barycentric * barycentric;
  return squared * squared * squared * barycentric;
}

V2i corner_shift(int i, int j, uint32_t seed, V2i size) {
  Random random(seed, (static_cast<uint64_t>(static_cast<uint32_t>(i)) << 32) | static_cast<uint32_t>(j));
  const auto x = static_cast<int>(random.below(static_cast<uint32_t>(size.x)));
  return {x, static_cast<int>(random.below(static_cast<uint32_t>(size.y)))};
}

}  // namespace

Image<V3f> periodic_baseline(ImageView<const V3f> exemplar, int width_px, int height_px) {
  Image<V3f> picture(width_px, height_px);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) picture(x, y) = exemplar(x % exemplar.width(), y % exemplar.height());
  return picture;
}

Image<V3f> hex_baseline_rows(ImageView<const V3f> exemplar, int width_px, int begin, int end, uint32_t seed) {
  const V2i size(exemplar.width(), exemplar.height());
  const double side_px = std::max(std::min(size.x, size.y) / 4.0, 1.0);
  Image<V3f> rows(width_px, end - begin);
  parallel_for(begin, end, [&](int y) {
    for (int x = 0; x < width_px; ++x) {
      // Skewed coordinates: the corners of the triangles are the integers.
      const double v = y / (side_px * 0.86602540378443864676);
      const double u = x / side_px - 0.5 * v;
      const int i = static_cast<int>(std::floor(u));
      const int j = static_cast<int>(std::floor(v));
      const double fu = u - i;
      const double fv = v - j;
      const bool upper = fu + fv > 1.0;
      const V2i corners[3] = {upper ? V2i(i + 1, j + 1) : V2i(i, j), V2i(i + 1, j), V2i(i, j + 1)};
      const double barycentric[3] = {upper ? fu + fv - 1.0 : 1.0 - fu - fv, upper ? 1.0 - fv : fu,
                                     upper ? 1.0 - fu : fv};
      V3f sum(0);
      double weights = 0.0;
      for (int c = 0; c < 3; ++c) {
        const V2i source = wrap(V2i(x, y) + corner_shift(corners[c].x, corners[c].y, seed, size), size);
        const V3f& color = exemplar(source.x, source.y);
        const double luminance = 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
        const double weight = sharpened(barycentric[c]) * ((1.0 - kContrast) + kContrast * luminance) + 1e-12;
        sum += color * static_cast<float>(weight);
        weights += weight;
      }
      rows(x, y - begin) = sum / static_cast<float>(weights);
    }
  });
  return rows;
}

}  // namespace texbake
