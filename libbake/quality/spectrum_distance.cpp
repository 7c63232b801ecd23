// F_psd of fidelity.h: radial × angular bins of averaged periodograms.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "libbake/base/fft.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/quality/fidelity.h"

namespace texbake {
namespace {

constexpr int kRadialBins = 10;
constexpr int kAngularBins = 8;
constexpr size_t kMaxSquares = 61;  // prime, so that steps of a grid do not keep to its columns
using Bins = std::array<double, kRadialBins * kAngularBins>;

// Bin of a frequency, or −1 for DC and for the corners beyond Nyquist. Radial edges are equal steps in octaves from
// 1.5/n to 0.5 cycles per pixel; angles are taken modulo π, since a real picture's spectrum is symmetric.
int bin_of(int kx, int ky, int n) {
  const double fx = static_cast<double>(kx <= n / 2 ? kx : kx - n) / n;
  const double fy = static_cast<double>(ky <= n / 2 ? ky : ky - n) / n;
  const double frequency_cpp = std::sqrt(fx * fx + fy * fy);
  const double lowest_cpp = 1.5 / n;
  if (frequency_cpp < lowest_cpp || frequency_cpp >= 0.5) return -1;
  const int radial = static_cast<int>(kRadialBins * std::log(frequency_cpp / lowest_cpp) / std::log(0.5 / lowest_cpp));
  double angle = std::atan2(fy, fx);
  if (angle < 0.0) angle += M_PI;
  const int angular = static_cast<int>(angle / M_PI * kAngularBins) % kAngularBins;
  return std::min(radial, kRadialBins - 1) * kAngularBins + angular;
}

double hann(int x, int n) { return 0.5 - 0.5 * portable_cos(2.0 * M_PI * (x + 0.5) / n); }

// Adds the power of the Hann-windowed square at (x0, y0), mean removed, to the bins.
void add_square(ImageView<const V3f> image, V2i origin, int n, ImageView<const int> bin, Bins& power) {
  const auto texel = [&](int x, int y) -> const V3f& {
    return image(wrap(origin.x + x, image.width()), wrap(origin.y + y, image.height()));
  };
  for (int channel = 0; channel < 3; ++channel) {
    double mean = 0.0;
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) mean += texel(x, y)[channel];
    mean /= static_cast<double>(n) * n;
    Image<float> square(n, n);
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        square(x, y) = static_cast<float>((texel(x, y)[channel] - mean) * hann(x, n) * hann(y, n));
    const Image<std::complex<float>> spectrum = fft<float>(square);
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        if (bin(x, y) >= 0) power[static_cast<size_t>(bin(x, y))] += std::norm(spectrum(x, y));
  }
}

// Mean power of each bin over squares at half overlap, on the torus of the image: all of them, or, of a large image, at
// most kMaxSquares, evenly spread.
Bins mean_power(ImageView<const V3f> image, int n, ImageView<const int> bin) {
  std::vector<V2i> origins;
  for (int y = 0; y < image.height(); y += n / 2)
    for (int x = 0; x < image.width(); x += n / 2) origins.emplace_back(x, y);
  std::vector<V2i> taken;
  const size_t count = std::min(origins.size(), kMaxSquares);
  for (size_t i = 0; i < count; ++i) taken.push_back(origins[i * origins.size() / count]);
  std::vector<Bins> powers(count, Bins{});
  parallel_for(0, static_cast<int>(count), [&](int i) {
    add_square(image, taken[static_cast<size_t>(i)], n, bin, powers[static_cast<size_t>(i)]);
  });
  Bins mean{};
  for (const Bins& power : powers)
    for (size_t b = 0; b < mean.size(); ++b) mean[b] += power[b] / static_cast<double>(powers.size());
  return mean;
}

}  // namespace

std::optional<double> spectrum_distance_db(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv) {
  // Squares of half the exemplar's side: sixteen of them on its torus make the estimate steady.
  const int n = std::min(exemplar_luv.width(), exemplar_luv.height()) / 2;
  if (n < 16 || rendering_luv.width() < 2 * n || rendering_luv.height() < 2 * n) return std::nullopt;
  Image<int> bin(n, n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) bin(x, y) = bin_of(x, y, n);
  const Bins expected = mean_power(exemplar_luv, n, bin);
  const Bins found = mean_power(rendering_luv, n, bin);

  // Bins without texels, or without power in the exemplar, say nothing.
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] <= 0.0) continue;
    const double decibel = 10.0 * std::log10(std::max(found[i], 1e-12) / expected[i]);
    sum += decibel * decibel;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(sum / count);
}

}  // namespace texbake
