#include "libbake/noise/spectrum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

struct Truth {
  const char* name;
  PowerLaw law;
  double feature_px;
};
const Truth kTruths[] = {{"ring, 40 px", ring_power, 40},
                         {"ring, 5 px", ring_power, 5},
                         {"blob, 40 px", blob_power, 40},
                         {"blob, 5 px", blob_power, 5}};
constexpr double kVariance = 0.01;

TEST(MaskedSpectrum, FindsAKnownSpectrumWithHalfOfTheTexelsMissing) {
  for (const Truth& truth : kTruths) {
    const Image<float> noise = synthetic_noise(truth.law, 512, kVariance, 1);
    const Image<uint8_t> mask = random_regions(512, truth.feature_px, 11);
    const Image<float> known = true_spectrum(truth.law, 64, kVariance);
    const Image<float> estimate = MaskedSpectrum(mask, 64, SpectrumEstimator::autocovariance).estimate(noise);
    // 0.12 is what the best prototype reached, 0.10-0.11, and a tenth.
    EXPECT_LE(power_error(estimate, known), 0.12) << truth.name;
    EXPECT_NEAR(power_of(estimate) / kVariance, 1.0, 0.03) << truth.name;

    const Image<float> paper = MaskedSpectrum(mask, 64, SpectrumEstimator::windows).estimate(noise);
    EXPECT_GT(power_error(paper, known), 1.5 * power_error(estimate, known)) << truth.name;
  }
}

TEST(MaskedSpectrum, WindowsOfThePaperFindASpectrumWithoutGaps) {
  const Image<float> noise = synthetic_noise(ring_power, 256, kVariance, 1);
  const Image<uint8_t> everywhere(256, 256, 1);
  const MaskedSpectrum estimator(everywhere, 32, SpectrumEstimator::windows);
  EXPECT_EQ(estimator.used_share(), 1.0);
  // 64 windows: each bin of power is known to 1/8.
  EXPECT_LE(power_error(estimator.estimate(noise), true_spectrum(ring_power, 32, kVariance)), 0.3);
}

/// Eq. 4 with every lag over its own pairs, by counting; then lag window, transform, clamp and scale as documented.
Image<float> slow_estimate(const Image<float>& noise, const Image<uint8_t>& mask, int size) {
  double sum = 0.0;
  double count = 0.0;
  for (size_t i = 0; i < noise.size(); ++i)
    if (mask.data()[i]) {
      sum += double(noise.data()[i]);
      count += 1.0;
    }
  const double mean = sum / count;
  double variance = 0.0;
  std::vector<std::pair<V2i, double>> covariance;
  for (int dy = -size / 2; dy <= size / 2; ++dy)
    for (int dx = -size / 2; dx <= size / 2; ++dx) {
      const double lag = std::sqrt(dx * dx + dy * dy);
      if (lag >= size / 2) continue;
      double products = 0.0;
      double pairs = 0.0;
      for (int y = 0; y < noise.height(); ++y)
        for (int x = 0; x < noise.width(); ++x) {
          const int ox = wrap(x + dx, noise.width());
          const int oy = wrap(y + dy, noise.height());
          if (!mask(x, y) || !mask(ox, oy)) continue;
          products += (double(noise(x, y)) - mean) * (double(noise(ox, oy)) - mean);
          pairs += 1.0;
        }
      covariance.push_back({{dx, dy}, products / pairs * (0.5 + 0.5 * std::cos(2.0 * M_PI * lag / size))});
      if (dx == 0 && dy == 0) variance = products / pairs;
    }
  Image<float> spectrum(size, size);
  double total = 0.0;
  std::vector<double> power;
  for (int v = 0; v < size; ++v)
    for (int u = 0; u < size; ++u) {
      double value = 0.0;
      for (const auto& [lag, c] : covariance) value += c * std::cos(2.0 * M_PI * (u * lag.x + v * lag.y) / size);
      power.push_back(u == 0 && v == 0 ? 0.0 : std::max(0.0, value));
      total += power.back();
    }
  for (size_t i = 0; i < power.size(); ++i)
    spectrum.data()[i] = static_cast<float>(std::sqrt(power[i] * variance / total));
  return spectrum;
}

TEST(MaskedSpectrum, EqualsTheSlowTwin) {
  const Image<float> noise = synthetic_noise(ring_power, 40, kVariance, 6);
  const Image<uint8_t> mask = random_regions(40, 12, 3);
  const Image<float> fast = MaskedSpectrum(mask, 8, SpectrumEstimator::autocovariance).estimate(noise);
  const Image<float> slow = slow_estimate(noise, mask, 8);
  for (size_t i = 0; i < fast.size(); ++i) EXPECT_NEAR(fast.data()[i], slow.data()[i], 2e-5);  // of magnitudes ~ 0.02
}

TEST(MaskedSpectrum, TakesASmallerSizeForASmallMask) {
  Image<uint8_t> mask(128, 128);
  for (int y = 20; y < 60; ++y)
    for (int x = 20; x < 60; ++x) mask(x, y) = 1;
  // 1600 texels: 4 · 16² = 1024 fit, 4 · 32² do not.
  EXPECT_EQ(MaskedSpectrum(mask, 64, SpectrumEstimator::autocovariance).size(), 16);
  const Image<uint8_t> few(128, 128);
  EXPECT_THROW(MaskedSpectrum(few, 64, SpectrumEstimator::autocovariance), Error);
}

TEST(MaskedSpectrum, SaysWhetherAMaskIsSmallOrScattered) {
  const auto message = [](const Image<uint8_t>& mask) -> std::string {
    try {
      MaskedSpectrum(mask, 64, SpectrumEstimator::autocovariance);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  Image<uint8_t> few(64, 64), scattered(64, 64);
  few(3, 4) = 1;
  for (int y = 0; y < 64; ++y)
    for (int x = y % 2; x < 64; x += 2) scattered(x, y) = 1;  // no two beside each other
  EXPECT_THAT(message(few), testing::HasSubstr("at least 64 texels in its mask, found 1;"));
  EXPECT_THAT(message(scattered), testing::HasSubstr("64 pairs of neighbors in its mask"));
}

TEST(LatticeSpectrum, KeepsPowerAndShape) {
  const Image<float> small = true_spectrum(blob_power, 32, 0.5);
  const NoiseLattice lattice{128 * 128, 6229};
  const Image<float> large = lattice_spectrum(small, lattice);
  EXPECT_NEAR(power_of(large), 0.5, 1e-5);
  EXPECT_LE(power_error(large, true_spectrum(blob_power, lattice, 0.5)),
            0.1);  // the peak at 0 is the mean of its neighbors
}

/// The autocovariance at a lag within ±T/2, by definition; the power at 0 is the mean of its neighbors'.
double lag_product(const Image<float>& spectrum, int x, int y) {
  const int size = spectrum.width();
  const auto power = [&](int u, int v) { return double(spectrum(u, v)) * double(spectrum(u, v)); };
  double sum = (power(1, 0) + power(0, 1)) / 2;
  for (int v = 0; v < size; ++v)
    for (int u = 0; u < size; ++u) sum += power(u, v) * std::cos(2 * M_PI * (u * x + v * y) / size);
  return sum * (2 * std::abs(x) == size ? 0.5 : 1.0) * (2 * std::abs(y) == size ? 0.5 : 1.0);
}

TEST(LatticeSpectrum, IsTheSumOverLagsAtEveryFrequency) {
  const Image<float> small = true_spectrum(ring_power, 8, 0.5);
  const NoiseLattice lattice{256, 161};
  const Image<float> found = lattice_spectrum(small, lattice);
  std::vector<double> power(256, 0.0);
  double total = 0.0;
  for (int k = 1; k < 256; ++k) {
    const Imath::V2d f = lattice.frequency(k);
    double& sum = power[static_cast<size_t>(k)];
    for (int y = -4; y <= 4; ++y)
      for (int x = -4; x <= 4; ++x) sum += lag_product(small, x, y) * std::cos(2 * M_PI * (f.x * x + f.y * y));
    total += sum = std::max(sum, 0.0);
  }
  for (int k = 0; k < 256; ++k)
    EXPECT_NEAR(double(found(k, 0)) * double(found(k, 0)), power[static_cast<size_t>(k)] * 0.5 / total, 1e-7) << k;
}

}  // namespace
}  // namespace texbake
