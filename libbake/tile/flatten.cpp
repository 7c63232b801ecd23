#include "libbake/tile/flatten.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/mean.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr float kLargestGain = 2;
constexpr double kLeastVariance = 0.01;  // ΔE²: where there is nothing, nothing is amplified

double mean_of(ImageView<const float> image) {
  double sum = 0.0;
  for (const float value : image) sum += static_cast<double>(value);
  return sum / static_cast<double>(image.size());
}

// (deviation of the tile / local deviation)^contrast, limited.
float gain(double tile_variance, double local_variance, double contrast) {
  const double ratio = (tile_variance + kLeastVariance) / (local_variance + kLeastVariance);
  const auto wanted = static_cast<float>(portable_pow(ratio, 0.5 * contrast));
  return std::clamp(wanted, 1.0f / kLargestGain, kLargestGain);
}

}  // namespace

Image<V3f> flatten(ImageView<const V3f> tile, const FlattenOptions& options) {
  check_options(options);
  Image<V3f> flat(tile.width(), tile.height());
  std::copy(tile.begin(), tile.end(), flat.begin());
  if (options.flatten_px <= 0) return flat;

  // Local mean, and local variance around it.
  const auto sigma_px = static_cast<double>(options.flatten_px);
  const Image<V3f> luv = luv_from_linear(tile);
  const Image<V3f> local_mean = gaussian_blur(luv, sigma_px, Wrap::repeat);
  Image<float> squared(tile.width(), tile.height());
  for (size_t i = 0; i < squared.size(); ++i) squared.data()[i] = (luv.data()[i] - local_mean.data()[i]).length2();
  const Image<float> local_variance = gaussian_blur(squared, sigma_px, Wrap::repeat);

  // The tile's own mean and variance in their place.
  const V3f tile_mean = mean_of(luv);
  const double tile_variance = mean_of(squared);
  parallel_for(0, flat.height(), [&](int y) {
    for (int x = 0; x < flat.width(); ++x) {
      const float g =
          gain(tile_variance, static_cast<double>(local_variance(x, y)), static_cast<double>(options.contrast));
      const V3f linear = linear_from_luv(tile_mean + (luv(x, y) - local_mean(x, y)) * g);
      for (int i = 0; i < 3; ++i) flat(x, y)[i] = std::max(linear[i], 0.0f);
    }
  });
  return flat;
}

}  // namespace texbake
