// Variances are sums over the three coordinates, accumulated by rows in a fixed order.
#include "libbake/quality/repetition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "libbake/base/error.h"
#include "libbake/base/gaussian.h"
#include "libbake/base/mean.h"
#include "libbake/base/parallel.h"
#include "libbake/quality/low_pass.h"

namespace texbake {
namespace {

// The sums of one row.
struct RowSums {
  double sum[3] = {};
  double squares = 0;
};

double variance(ImageView<const V3f> image) {
  std::vector<RowSums> rows(static_cast<size_t>(image.height()));
  parallel_for(0, image.height(), [&](int y) {
    RowSums& row = rows[static_cast<size_t>(y)];
    for (int x = 0; x < image.width(); ++x)
      for (int i = 0; i < 3; ++i) {
        const double value = image(x, y)[i];
        row.sum[i] += value;
        row.squares += value * value;
      }
  });
  RowSums total;
  for (const RowSums& row : rows) {
    for (int i = 0; i < 3; ++i) total.sum[i] += row.sum[i];
    total.squares += row.squares;
  }
  const auto n = static_cast<double>(image.size());
  const double of_sums = total.sum[0] * total.sum[0] + total.sum[1] * total.sum[1] + total.sum[2] * total.sum[2];
  return total.squares / n - of_sums / (n * n);
}

Image<V3f> mean_over_tiles(ImageView<const V3f> image, V2i tile) {
  const int tiles = (image.width() / tile.x) * (image.height() / tile.y);
  Image<V3f> mean(tile.x, tile.y);
  parallel_for(0, tile.y, [&](int y) {
    for (int from = y; from < image.height(); from += tile.y)
      for (int x = 0; x < image.width(); ++x) mean(x % tile.x, y) += image(x, from);
    for (int x = 0; x < tile.x; ++x) mean(x, y) /= static_cast<float>(tiles);
  });
  return mean;
}

// How many tiles the rendering holds on each axis.
V2i whole_tiles(ImageView<const V3f> rendering, V2i tile) {
  const V2i tiles(rendering.width() / std::max(tile.x, 1), rendering.height() / std::max(tile.y, 1));
  if (tiles.x * tile.x != rendering.width() || tiles.y * tile.y != rendering.height() || tiles.x * tiles.y < 2)
    throw Error(ErrorKind::usage, fmt::format("repetition: expected a rendering of two or more whole {} x {} tiles, "
                                              "found {} x {} texels",
                                              tile.x, tile.y, rendering.width(), rendering.height()));
  return tiles;
}

}  // namespace

std::optional<Repetition> repetition(ImageView<const V3f> rendering_luv, V2i tile, double sigma_px) {
  const V2i tiles = whole_tiles(rendering_luv, tile);
  const int factor = reduction_factor(tile, sigma_px);
  Image<V3f> passed;
  if (sigma_px > 0.0) passed = low_pass(rendering_luv, sigma_px, factor);
  const ImageView<const V3f> low = sigma_px > 0.0 ? passed.view() : rendering_luv;
  const double v = variance(low);
  if (v < 1e-6) return std::nullopt;  // below 0.001 ΔE: float noise
  const double v_mean = variance(mean_over_tiles(low, tile / factor));
  const double n = static_cast<double>(tiles.x) * tiles.y;
  const double share = (v_mean - v / n) / (v * (1.0 - 1.0 / n));
  return Repetition{share, std::sqrt(std::max(share, 0.0) * v)};
}

Image<float> repetition_map(ImageView<const V3f> rendering_luv, V2i tile) {
  const V2i tiles = whole_tiles(rendering_luv, tile);
  const double sigma_px = std::min(tile.x, tile.y) / 32.0;
  const int factor = reduction_factor(tile, sigma_px / 2.0);
  const Image<V3f> reduced = reduce(rendering_luv, factor);
  const V2i size = tile / factor;
  const Image<V3f> mean = mean_over_tiles(reduced, size);
  const V3f overall = mean_of(mean);

  Image<float> shared(size.x, size.y);
  Image<float> all(size.x, size.y);
  const float n = static_cast<float>(tiles.x) * static_cast<float>(tiles.y);
  parallel_for(0, size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      shared(x, y) = (mean(x, y) - overall).length2();
      for (int j = 0; j < tiles.y; ++j)
        for (int i = 0; i < tiles.x; ++i)
          all(x, y) += (reduced(x + i * size.x, y + j * size.y) - overall).length2() / n;
    }
  });
  shared = gaussian_blur(shared, sigma_px / factor, Wrap::repeat);
  all = gaussian_blur(all, sigma_px / factor, Wrap::repeat);
  for (size_t i = 0; i < all.size(); ++i) {
    const float energy = all.data()[i];
    const float share = energy > 1e-3f ? (shared.data()[i] / energy - 1.0f / n) / (1.0f - 1.0f / n) : 0.0f;
    shared.data()[i] = std::clamp(share, 0.0f, 1.0f);
  }
  return shared;
}

}  // namespace texbake
