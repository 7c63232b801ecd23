#include "libbake/noise/noise_tile.h"

#include <gtest/gtest.h>

#include "libbake/noise/lobes.h"
#include "libbake/noise/spectrum.h"
#include "libbake/noise/spectrum_difference.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

double correlation(const Image<float>& a, const Image<float>& b) {
  double ab = 0.0;
  for (size_t i = 0; i < a.size(); ++i) ab += double(a.data()[i]) * double(b.data()[i]);
  return ab / double(a.size()) / std::sqrt(variance_of(a) * variance_of(b));
}

TEST(RandomPhases, AreHermitianAndOfUnitLength) {
  const auto phases = random_phases(16, 1, 0);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      EXPECT_NEAR(std::abs(phases(x, y)), 1.0f, 1e-6f);
      EXPECT_EQ(phases(x, y), std::conj(phases(wrap(-x, 16), wrap(-y, 16))));
    }
}

TEST(RealiseNoise, HasTheVarianceAndTheSpectrumOfItsModel) {
  for (const PowerLaw& law : {PowerLaw(ring_power), PowerLaw(blob_power)}) {
    const Image<float> spectrum = true_spectrum(law, 128, 0.02);
    const Image<float> noise = realise_noise(spectrum, random_phases(128, 1, 0));
    EXPECT_NEAR(variance_of(noise), 0.02, 1e-6);  // exact but for the float transform
    double sum = 0.0;
    for (const float value : noise) sum += double(value);
    EXPECT_NEAR(sum / double(noise.size()), 0.0, 1e-7);
    EXPECT_LE(spectrum_difference_db(periodogram(noise), spectrum), 0.01);
  }
}

TEST(RealiseNoise, ChannelsAreIndependent) {
  const Image<float> spectrum = true_spectrum(ring_power, 256, 1.0);
  const Image<float> a = realise_noise(spectrum, random_phases(256, 1, 0));
  for (const int channel : {1, 2})
    EXPECT_NEAR(correlation(a, realise_noise(spectrum, random_phases(256, 1, channel))), 0.0, 0.05);
  EXPECT_NEAR(correlation(a, realise_noise(spectrum, random_phases(256, 2, 0))), 0.0, 0.05);
  EXPECT_NEAR(correlation(a, realise_noise(spectrum, random_phases(256, 1, 0))), 1.0, 1e-6);
}

TEST(RealiseNoise, AnEvenBlendKeepsTheDeviationBecausePhasesAreShared) {
  // Same shape, powers 1 and 4: deviations 1 and 2, an even blend has 1.5.
  const Image<float> weak = true_spectrum(ring_power, 128, 1.0);
  const Image<float> strong = true_spectrum(ring_power, 128, 4.0);
  const Image<float> a = realise_noise(weak, random_phases(128, 1, 0));
  const Image<float> shared = realise_noise(strong, random_phases(128, 1, 0));
  const Image<float> apart = realise_noise(strong, random_phases(128, 2, 0));
  Image<float> blend(128, 128);
  Image<float> independent(128, 128);
  for (size_t i = 0; i < blend.size(); ++i) {
    blend.data()[i] = 0.5f * (a.data()[i] + shared.data()[i]);
    independent.data()[i] = 0.5f * (a.data()[i] + apart.data()[i]);
  }
  EXPECT_NEAR(std::sqrt(variance_of(blend)) / 1.5, 1.0, 1e-4);
  EXPECT_NEAR(std::sqrt(variance_of(independent)) / 1.5, std::sqrt(5.0) / 3.0, 0.03);  // what it would lose: 25 %
}

TEST(RealiseNoise, ABlendHasTheBlendedMagnitudes) {
  const Image<float> ring = true_spectrum(ring_power, 64, 1.0);
  const Image<float> blob = true_spectrum(blob_power, 64, 1.0);
  const auto phases = random_phases(64, 1, 0);
  const Image<float> a = realise_noise(ring, phases);
  const Image<float> b = realise_noise(blob, phases);
  Image<float> mixed(64, 64);
  for (size_t i = 0; i < mixed.size(); ++i) mixed.data()[i] = 0.3f * ring.data()[i] + 0.7f * blob.data()[i];
  const Image<float> c = realise_noise(mixed, phases);
  for (size_t i = 0; i < c.size(); ++i)
    EXPECT_NEAR(c.data()[i], 0.3f * a.data()[i] + 0.7f * b.data()[i], 1e-5f);  // linear: S_x = Σ M_k S_k (§3.2)
}

Image<V3f> grey(const Image<float>& plane) {
  Image<V3f> image(plane.width(), plane.height());
  for (size_t i = 0; i < plane.size(); ++i) image.data()[i] = V3f(plane.data()[i]);
  return image;
}

TEST(NoiseLevels, OfSlowNoiseAreTheMeansOfTheTexels) {
  // A wave of 2 cycles in 32 texels: no frequency turns into another one, so the faded level is the box mean.
  Image<float> wave(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) wave(x, y) = static_cast<float>(std::cos(2.0 * M_PI * (2 * x + y) / 32.0 + 0.3));
  const auto levels = noise_levels(grey(wave), 3);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      double mean = 0.0;
      for (int b = 0; b < 4; ++b)
        for (int a = 0; a < 4; ++a) mean += double(wave(4 * x + a, 4 * y + b)) / 16.0;
      EXPECT_NEAR(levels[2](x, y).x, mean, 1e-5);
    }
}

TEST(NoiseLevels, FadeAsTheTransferSays) {
  const Image<float> spectrum = true_spectrum([](double, double) { return 1.0; }, 64, 1.0);  // white
  const auto levels = noise_levels(grey(realise_noise(spectrum, random_phases(64, 1, 0))), 4);
  for (int level = 0; level < 4; ++level) {
    double expected = 0.0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        expected += double(spectrum(x, y)) * double(spectrum(x, y)) *
                    level_transfer_power(shortest(x, 64) / 64.0, shortest(y, 64) / 64.0, level);
    Image<float> plane(64 >> level, 64 >> level);
    for (size_t i = 0; i < plane.size(); ++i) plane.data()[i] = levels[size_t(level)].data()[i].y;
    EXPECT_NEAR(variance_of(plane) / expected, 1.0, 1e-4) << level;
  }
}

TEST(NoiseLevels, AgreeWithTheClosedFormOfLobes) {
  // A lobe of deviation 0.02 cycles per texel at 0.05; a box of 2^l texels has the variance (4^l − 1)/12.
  const Lobe lobes[] = {{1.0, 0.05, 0.0, 50.0, 0.0, 50.0}};
  const Image<float> spectrum = lobe_spectrum(lobes, 256);
  const auto levels = noise_levels(grey(realise_noise(spectrum, random_phases(256, 1, 0))), 3);
  for (int level = 0; level < 3; ++level) {
    Image<float> plane(256 >> level, 256 >> level);
    for (size_t i = 0; i < plane.size(); ++i) plane.data()[i] = levels[size_t(level)].data()[i].x;
    const double box = (std::pow(4.0, level) - 1.0) / 12.0;
    // The box is not Gaussian: at the second zero of its transfer the difference is a few percent of the power.
    EXPECT_NEAR(variance_of(plane), filtered_variance(lobes, box, 0.0, box), 0.03) << level;
  }
}

}  // namespace
}  // namespace texbake
