#include "libbake/noise/synthesis_test.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/torus.h"

namespace texbake {
namespace {

constexpr std::array kBandSigmas = {1.0, 2.0, 4.0, 8.0, 16.0, 32.0};  // px
constexpr double kEnergySmoothing = 6.0;                              // px
constexpr double kTensorSmoothing = 2.0;                              // px

/// Σ over the bands of their squares, smoothed.
Image<float> band_energy(ImageView<const float> image) {
  Image<float> energy(image.width(), image.height());
  Image<float> finer(image.width(), image.height());
  std::copy(image.begin(), image.end(), finer.begin());
  for (const double sigma : kBandSigmas) {
    Image<float> coarser = gaussian_blur(image, sigma, Wrap::repeat);
    for (size_t i = 0; i < energy.size(); ++i) {
      const float band = finer.data()[i] - coarser.data()[i];
      energy.data()[i] += band * band;
    }
    finer = std::move(coarser);
  }
  return gaussian_blur(energy, kEnergySmoothing, Wrap::repeat);
}

}  // namespace

double energy_deviation(ImageView<const float> a, ImageView<const float> b) {
  const Image<float> energy_a = band_energy(a);
  const Image<float> energy_b = band_energy(b);
  constexpr double kLeast = 1e-12;  // a flat place has a logarithm too
  double sum = 0.0;
  double squares = 0.0;
  for (size_t i = 0; i < energy_a.size(); ++i) {
    const double difference = portable_log((static_cast<double>(energy_a.data()[i]) + kLeast) /
                                           (static_cast<double>(energy_b.data()[i]) + kLeast));
    sum += difference;
    squares += difference * difference;
  }
  const auto count = static_cast<double>(energy_a.size());
  return std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
}

double mean_coherence(ImageView<const float> luminance) {
  const int width = luminance.width();
  const int height = luminance.height();
  Image<V3f> tensor(width, height);  // xx, xy, yy
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float dx = luminance(wrap(x + 1, width), y) - luminance(wrap(x - 1, width), y);
      const float dy = luminance(x, wrap(y + 1, height)) - luminance(x, wrap(y - 1, height));
      tensor(x, y) = {dx * dx, dx * dy, dy * dy};
    }
  tensor = gaussian_blur(tensor, kTensorSmoothing, Wrap::repeat);
  double sum = 0.0;
  for (const V3f& t : tensor) {
    const double trace = static_cast<double>(t.x) + static_cast<double>(t.z);
    const double difference = static_cast<double>(t.x) - static_cast<double>(t.z);
    const double twice_xy = 2.0 * static_cast<double>(t.y);
    if (trace > 1e-12) sum += std::sqrt(difference * difference + twice_xy * twice_xy) / trace;
  }
  return sum / static_cast<double>(tensor.size());
}

}  // namespace texbake
