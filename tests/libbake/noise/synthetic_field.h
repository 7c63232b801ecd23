// Fields with a known truth: Gaussian noises of given spectra, and regions of a given size.
#pragma once

#include <cmath>
#include <complex>
#include <functional>

#include "libbake/base/fft.h"
#include "libbake/base/gaussian.h"
#include "libbake/base/image.h"
#include "libbake/base/random.h"
#include "libbake/base/torus.h"
#include "libbake/noise/noise_lattice.h"

namespace texbake {

/// Power as a function of the frequency in cycles per texel, up to a factor; even.
using PowerLaw = std::function<double(double fx, double fy)>;

inline double ring_power(double fx, double fy) {
  const double r = std::sqrt(fx * fx + fy * fy);
  return std::exp(-(r - 0.18) * (r - 0.18) / (2 * 0.03 * 0.03));
}
inline double blob_power(double fx, double fy) { return std::exp(-(fx * fx + fy * fy) / (2 * 0.05 * 0.05)); }

/// The table of magnitudes that an estimate should find: S(0) = 0, Σ S² = variance.
inline Image<float> true_spectrum(const PowerLaw& law, int size, double variance) {
  Image<float> spectrum(size, size);
  double total = 0.0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (x != 0 || y != 0) total += law(shortest(x, size) / double(size), shortest(y, size) / double(size));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (x != 0 || y != 0)
        spectrum(x, y) = static_cast<float>(
            std::sqrt(law(shortest(x, size) / double(size), shortest(y, size) / double(size)) * variance / total));
  return spectrum;
}

/// The same at the frequencies of a lattice, count×1.
inline Image<float> true_spectrum(const PowerLaw& law, const NoiseLattice& lattice, double variance) {
  Image<float> spectrum(lattice.count, 1);
  double total = 0.0;
  for (int k = 1; k < lattice.count; ++k) total += law(lattice.frequency(k).x, lattice.frequency(k).y);
  for (int k = 1; k < lattice.count; ++k)
    spectrum(k, 0) =
        static_cast<float>(std::sqrt(law(lattice.frequency(k).x, lattice.frequency(k).y) * variance / total));
  return spectrum;
}

/// side × side texels of the plane that a noise on a lattice covers.
inline Image<float> unrolled(const Image<float>& noise, const NoiseLattice& lattice, int side) {
  Image<float> plane(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      plane(x, y) = noise.data()[lattice.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y))];
  return plane;
}

/// A picture that does not repeat, under a Hann window of unit power, for a periodogram.
inline Image<float> windowed(const Image<float>& picture) {
  Image<float> result(picture.width(), picture.height());
  const auto hann = [](int i, int n) {
    return std::sqrt(8.0 / 3.0) * (0.5 - 0.5 * std::cos(2 * M_PI * (i + 0.5) / n));
  };
  double mean = 0.0;
  for (const float value : picture) mean += double(value) / double(picture.size());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      result(x, y) =
          static_cast<float>((double(picture(x, y)) - mean) * hann(x, picture.width()) * hann(y, picture.height()));
  return result;
}

/// Independent normal values: sums of twelve uniform ones.
inline Image<float> white_noise(int size, uint32_t seed) {
  Random random(seed, 77);
  Image<float> image(size, size);
  for (float& value : image) {
    for (int i = 0; i < 12; ++i) value += random.uniform();
    value -= 6.0f;
  }
  return image;
}

/// White noise filtered to the power law: periodic, Gaussian, of the given expected variance.
inline Image<float> synthetic_noise(const PowerLaw& law, int size, double variance, uint32_t seed) {
  Image<std::complex<float>> transform = fft<float>(white_noise(size, seed));
  const Image<float> filter = true_spectrum(law, size, variance);
  for (size_t i = 0; i < transform.size(); ++i) transform.data()[i] *= filter.data()[i] * static_cast<float>(size);
  return inverse_fft_real<float>(transform);
}

/// Two regions of random shape, half of the texels each; features are about `feature_px` wide.
inline Image<uint8_t> random_regions(int size, double feature_px, uint32_t seed) {
  const Image<float> smooth = gaussian_blur(white_noise(size, seed), feature_px / 4.0, Wrap::repeat);
  Image<uint8_t> region(size, size);
  for (size_t i = 0; i < smooth.size(); ++i) region.data()[i] = smooth.data()[i] > 0.0f ? 1 : 0;
  return region;
}

/// ‖a² − b²‖ / ‖b²‖ of two tables of magnitudes.
inline double power_error(const Image<float>& a, const Image<float>& b) {
  double difference = 0.0;
  double total = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double pa = double(a.data()[i]) * double(a.data()[i]);
    const double pb = double(b.data()[i]) * double(b.data()[i]);
    difference += (pa - pb) * (pa - pb);
    total += pb * pb;
  }
  return std::sqrt(difference / total);
}

inline double power_of(const Image<float>& spectrum) {
  double sum = 0.0;
  for (const float s : spectrum) sum += double(s) * double(s);
  return sum;
}

/// Mean square about the mean.
inline double variance_of(const Image<float>& image) {
  double sum = 0.0;
  double squares = 0.0;
  for (const float v : image) sum += double(v);
  const double mean = sum / double(image.size());
  for (const float v : image) squares += (double(v) - mean) * (double(v) - mean);
  return squares / double(image.size());
}

}  // namespace texbake
