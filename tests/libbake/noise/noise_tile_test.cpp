#include "libbake/noise/noise_tile.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace texbake
