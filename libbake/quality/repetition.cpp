// Variances are sums over the three coordinates, accumulated by rows in a fixed order.
#include "libbake/quality/repetition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/error.h"
#include "libbake/quality/low_pass.h"

namespace texbake {
namespace {

double variance(ImageView<const V3f> image) {
  double sum[3] = {};
  double squares = 0.0;
  for (const V3f& c : image)
    for (int i = 0; i < 3; ++i) {
      sum[i] += c[i];
      squares += static_cast<double>(c[i]) * c[i];
    }
  const auto n = static_cast<double>(image.size());
  return squares / n - (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / (n * n);
}

Image<V3f> mean_over_tiles(ImageView<const V3f> image, V2i tile) {
  const int tiles = (image.width() / tile.x) * (image.height() / tile.y);
  Image<V3f> mean(tile.x, tile.y);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) mean(x % tile.x, y % tile.y) += image(x, y);
  for (V3f& c : mean) c /= static_cast<float>(tiles);
  return mean;
}

}  // namespace

std::optional<Repetition> repetition(ImageView<const V3f> rendering_luv, V2i tile, double sigma_px) {
  const int tiles_x = rendering_luv.width() / std::max(tile.x, 1);
  const int tiles_y = rendering_luv.height() / std::max(tile.y, 1);
  if (tiles_x * tile.x != rendering_luv.width() || tiles_y * tile.y != rendering_luv.height() || tiles_x * tiles_y < 2)
    throw Error(ErrorKind::usage, fmt::format("repetition: expected a rendering of two or more whole {} x {} tiles, "
                                              "found {} x {} texels",
                                              tile.x, tile.y, rendering_luv.width(), rendering_luv.height()));
  const int factor = reduction_factor(tile, sigma_px);
  const Image<V3f> low = low_pass(rendering_luv, sigma_px, factor);
  const double v = variance(low);
  if (v < 1e-6) return std::nullopt;  // below 0.001 ΔE: float noise
  const double v_mean = variance(mean_over_tiles(low, tile / factor));
  const double n = static_cast<double>(tiles_x) * tiles_y;
  const double share = (v_mean - v / n) / (v * (1.0 - 1.0 / n));
  return Repetition{share, std::sqrt(std::max(share, 0.0) * v)};
}

}  // namespace texbake
