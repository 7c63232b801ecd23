// Both estimators in the frequency domain. The whole tile is transformed as the torus it is: pairs across its border
// are pairs like the others, and no zero padding is needed.
#include "libbake/noise/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "libbake/base/error.h"
#include "libbake/base/fft.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/torus.h"

namespace texbake {
namespace {

constexpr double kLeastPairs = 64;
constexpr double kPaperCoverage = 0.7;

/// Σ_p image(p) · image(p + lag) at every lag of the torus.
Image<float> circular_autocorrelation(ImageView<const float> image) {
  Image<std::complex<float>> transform = fft<float>(image);
  for (std::complex<float>& value : transform)
    value = {value.real() * value.real() + value.imag() * value.imag(), 0.0f};
  return inverse_fft_real<float>(transform);
}

/// Clamped at 0, without its mean, scaled to Σ = variance, as magnitudes.
Image<float> magnitudes(Image<double> power, double variance) {
  power(0, 0) = 0.0;
  double total = 0.0;
  for (double& value : power) {
    value = std::max(value, 0.0);
    total += value;
  }
  Image<float> result(power.width(), power.height());
  if (!(total > 0.0)) return result;
  for (size_t i = 0; i < power.size(); ++i)
    result.data()[i] = static_cast<float>(std::sqrt(power.data()[i] * (variance / total)));
  return result;
}

/// The real part of the transform of a real, even image, made exactly even.
template <class T>
Image<double> even_transform(ImageView<const T> image) {
  const Image<std::complex<T>> transform = fft<T>(image);
  const int width = image.width();
  const int height = image.height();
  Image<double> result(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      result(x, y) = 0.5 * (static_cast<double>(transform(x, y).real()) +
                            static_cast<double>(transform(wrap(-x, width), wrap(-y, height)).real()));
  return result;
}

Error too_small(int64_t texels) {
  constexpr int kLeast = 4 * MaskedSpectrum::kSmallestSize * MaskedSpectrum::kSmallestSize;
  const std::string wanted =
      texels < kLeast ? fmt::format("at least {} texels in its mask, found {}", kLeast, texels)
                      : fmt::format("{} pairs of neighbors in its mask, found fewer among {} scattered texels",
                                    kLeastPairs, texels);
  return Error(ErrorKind::infeasible,
               fmt::format("the spectrum of a noise needs {}; ask for fewer noises or a larger exemplar", wanted));
}

}  // namespace

MaskedSpectrum::MaskedSpectrum(ImageView<const uint8_t> mask, int size, SpectrumEstimator estimator)
    : mask_(mask), estimator_(estimator), size_(size) {
  Image<float> inside(mask.width(), mask.height());
  for (size_t i = 0; i < mask.size(); ++i) {
    inside.data()[i] = mask.data()[i] != 0 ? 1.0f : 0.0f;
    count_ += mask.data()[i] != 0 ? 1 : 0;
  }
  pairs_ = circular_autocorrelation(inside);
  while (size_ >= kSmallestSize && !supports(size_)) size_ /= 2;
  if (size_ < kSmallestSize) throw too_small(count_);
  if (estimator == SpectrumEstimator::windows) choose_windows();
}

bool MaskedSpectrum::supports(int size) const {
  if (std::min(mask_.width(), mask_.height()) < size || count_ < 4 * static_cast<int64_t>(size) * size) return false;
  for (int dy = 0; dy < size / 2; ++dy)
    for (int dx = -size / 2 + 1; dx < size / 2; ++dx)
      if (dx * dx + dy * dy < size * size / 4 && pairs_(wrap(dx, mask_.width()), dy) < static_cast<float>(kLeastPairs))
        return false;
  return true;
}

Image<float> MaskedSpectrum::estimate(ImageView<const float> noise) const {
  const double mean = masked_mean(noise, mask_);
  Image<float> centerd(noise.width(), noise.height());
  double squares = 0.0;
  for (size_t i = 0; i < noise.size(); ++i) {
    if (mask_.data()[i] == 0) continue;
    centerd.data()[i] = static_cast<float>(static_cast<double>(noise.data()[i]) - mean);
    squares += static_cast<double>(centerd.data()[i]) * static_cast<double>(centerd.data()[i]);
  }
  return magnitudes(estimator_ == SpectrumEstimator::windows ? windows_power(centerd) : autocovariance_power(centerd),
                    squares / static_cast<double>(count_));
}

/// The mean product over the pairs of each lag, times ½ + ½ cos(2π|lag|/T) for |lag| < T/2, transformed.
Image<double> MaskedSpectrum::autocovariance_power(ImageView<const float> centerd) const {
  const Image<float> products = circular_autocorrelation(centerd);
  Image<double> windowed(size_, size_);
  for (int y = 0; y < size_; ++y)
    for (int x = 0; x < size_; ++x) {
      const int dx = shortest(x, size_);
      const int dy = shortest(y, size_);
      const double lag = std::sqrt(static_cast<double>(dx * dx + dy * dy));
      if (lag >= size_ / 2) continue;
      const V2i place = wrap(V2i(dx, dy), V2i(mask_.width(), mask_.height()));
      windowed(x, y) = static_cast<double>(products(place.x, place.y)) / static_cast<double>(pairs_(place.x, place.y)) *
                       (0.5 + 0.5 * portable_cos(2.0 * std::numbers::pi * lag / size_));
    }
  return even_transform<double>(windowed);
}

/// Eq. 4-5: a window's circular autocovariance, normalized by |M ∩ Y|, transforms to |FFT(M · I)|² / |M ∩ Y|, so that
/// the mean weighted by |M ∩ Y| is the sum of |FFT(M · I)|².
Image<double> MaskedSpectrum::windows_power(ImageView<const float> centerd) const {
  Image<double> power(size_, size_);
  Image<double> window(size_, size_);
  for (int top = 0; top + size_ <= mask_.height(); top += size_)
    for (int left = 0; left + size_ <= mask_.width(); left += size_) {
      int inside = 0;
      for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x) {
          window(x, y) = static_cast<double>(centerd(left + x, top + y));
          inside += mask_(left + x, top + y) != 0 ? 1 : 0;
        }
      if (inside < least_coverage_ * size_ * size_) continue;
      const Image<std::complex<double>> transform = fft<double>(window);
      for (size_t i = 0; i < power.size(); ++i) power.data()[i] += std::norm(transform.data()[i]);
    }
  return power;
}

void MaskedSpectrum::choose_windows() {
  least_coverage_ = kPaperCoverage;
  int64_t used = 0;
  for (int top = 0; top + size_ <= mask_.height(); top += size_)
    for (int left = 0; left + size_ <= mask_.width(); left += size_) {
      int inside = 0;
      for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x) inside += mask_(left + x, top + y) != 0 ? 1 : 0;
      if (inside >= least_coverage_ * size_ * size_) used += inside;
    }
  used_share_ = static_cast<double>(used) / static_cast<double>(count_);
  if (used > 0) return;
  least_coverage_ = 0.0;
  used_share_ = 1.0;
}

double masked_mean(ImageView<const float> image, ImageView<const uint8_t> mask) {
  double sum = 0.0;
  int64_t count = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    if (mask.data()[i] == 0) continue;
    sum += static_cast<double>(image.data()[i]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

double spectrum_power(ImageView<const float> spectrum) {
  double sum = 0.0;
  for (const float magnitude : spectrum) sum += static_cast<double>(magnitude) * static_cast<double>(magnitude);
  return sum;
}

Image<float> periodogram(ImageView<const float> tile) {
  const Image<std::complex<float>> transform = fft<float>(tile);
  Image<float> spectrum(tile.width(), tile.height());
  const float scale = 1.0f / static_cast<float>(tile.size());
  for (size_t i = 0; i < spectrum.size(); ++i) {
    const std::complex<float> value = transform.data()[i] * scale;
    spectrum.data()[i] = std::sqrt(value.real() * value.real() + value.imag() * value.imag());
  }
  spectrum(0, 0) = 0.0f;
  return spectrum;
}

Image<float> lattice_spectrum(ImageView<const float> spectrum, const NoiseLattice& lattice) {
  const int from = spectrum.width();
  Image<double> power(from, from);
  for (size_t i = 0; i < power.size(); ++i)
    power.data()[i] = static_cast<double>(spectrum.data()[i]) * static_cast<double>(spectrum.data()[i]);
  // S(0) is 0 by definition; between it and its neighbors the power does not dip.
  power(0, 0) = 0.25 * (power(1, 0) + power(from - 1, 0) + power(0, 1) + power(0, from - 1));
  const Image<double> autocovariance = even_transform<double>(power);

  // Lags of ±T/2 are one sample of the torus and two of the lattice.
  Image<float> continued(lattice.count, 1);
  for (int y = -from / 2; y <= from / 2; ++y)
    for (int x = -from / 2; x <= from / 2; ++x) {
      const double share = (2 * std::abs(x) == from ? 0.5 : 1.0) * (2 * std::abs(y) == from ? 0.5 : 1.0);
      continued.data()[lattice.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y))] +=
          static_cast<float>(share * autocovariance(wrap(x, from), wrap(y, from)));
    }
  return magnitudes(even_transform<float>(continued), spectrum_power(spectrum));
}

}  // namespace texbake
