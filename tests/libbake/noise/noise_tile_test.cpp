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

constexpr NoiseLattice kLattice{128 * 128, 6229};

Image<float> realised(const Image<float>& spectrum, uint32_t seed, int channel) {
  return realise_noise(spectrum, random_phases(spectrum.width(), seed, channel));
}

TEST(RandomPhases, AreHermitianAndOfUnitLength) {
  const auto phases = random_phases(64, 1, 0);
  for (int k = 0; k < 64; ++k) {
    EXPECT_NEAR(std::abs(phases(k, 0)), 1.0f, 1e-6f);
    EXPECT_EQ(phases(k, 0), std::conj(phases(wrap(-k, 64), 0)));
  }
  EXPECT_EQ(phases(0, 0).imag(), 0.0f);
  EXPECT_EQ(phases(32, 0).imag(), 0.0f);
}

TEST(RealiseNoise, IsTheSumOfWavesOnThePlane) {
  // The obvious way: at every texel of the plane, all waves of the lattice's frequencies.
  const NoiseLattice lattice{256, 161};
  const Image<float> spectrum = true_spectrum(blob_power, lattice, 1.0);
  const auto phases = random_phases(256, 5, 0);
  const Image<float> noise = realise_noise(spectrum, phases);
  for (const V2i& p : {V2i(0, 0), V2i(1, 0), V2i(0, 1), V2i(15, 9), V2i(-3, 700), V2i(12345, -6789)}) {
    double sum = 0.0;
    for (int k = 0; k < 256; ++k) {
      const Imath::V2d f = lattice.frequency(k);
      sum += double(spectrum(k, 0)) * std::cos(2 * M_PI * (f.x * p.x + f.y * p.y) + double(std::arg(phases(k, 0))));
    }
    const uint32_t index = lattice.index(static_cast<uint32_t>(p.x), static_cast<uint32_t>(p.y));
    EXPECT_NEAR(double(noise.data()[index]), sum, 1e-5);
  }
}

TEST(RealiseNoise, HasTheVarianceAndTheSpectrumOfItsModel) {
  for (const PowerLaw& law : {PowerLaw(ring_power), PowerLaw(blob_power)}) {
    const Image<float> spectrum = true_spectrum(law, kLattice, 0.02);
    const Image<float> noise = realised(spectrum, 1, 0);
    EXPECT_NEAR(variance_of(noise), 0.02, 1e-6);  // exact but for the float transform
    double sum = 0.0;
    for (const float value : noise) sum += double(value);
    EXPECT_NEAR(sum / double(noise.size()), 0.0, 1e-7);
    EXPECT_LE(spectrum_difference_db(periodogram(noise), spectrum, kLattice), 0.01);
  }
}

TEST(RealiseNoise, OnThePlaneItHasTheSpectrumInEveryDirection) {
  // A window sees a bin through a few thousand frequencies of random phase; where the spectrum is steep, few count.
  const PowerLaw streaks = [](double fx, double fy) { return ring_power(2 * fx, 0.5 * fy); };
  const NoiseLattice lattice = noise_lattice(1024);
  for (const PowerLaw& law : {PowerLaw(ring_power), PowerLaw(blob_power), streaks}) {
    const Image<float> noise = realised(true_spectrum(law, lattice, 0.02), 1, 0);
    const Image<float> seen = periodogram(windowed(unrolled(noise, lattice, 512)));
    EXPECT_LE(spectrum_difference_db(seen, true_spectrum(law, 512, 0.02)), 1.0);
  }
}

TEST(RealiseNoise, ChannelsAreIndependent) {
  const Image<float> spectrum = true_spectrum(ring_power, noise_lattice(512), 1.0);
  const Image<float> a = realised(spectrum, 1, 0);
  for (const int channel : {1, 2}) EXPECT_NEAR(correlation(a, realised(spectrum, 1, channel)), 0.0, 0.025);
  EXPECT_NEAR(correlation(a, realised(spectrum, 2, 0)), 0.0, 0.025);
  EXPECT_NEAR(correlation(a, realised(spectrum, 1, 0)), 1.0, 1e-6);
}

TEST(RealiseNoise, AnEvenBlendKeepsTheDeviationBecausePhasesAreShared) {
  // Same shape, powers 1 and 4: deviations 1 and 2, an even blend has 1.5.
  const Image<float> weak = true_spectrum(ring_power, kLattice, 1.0);
  const Image<float> strong = true_spectrum(ring_power, kLattice, 4.0);
  const Image<float> a = realised(weak, 1, 0);
  const Image<float> shared = realised(strong, 1, 0);
  const Image<float> apart = realised(strong, 2, 0);
  Image<float> blend(kLattice.count, 1);
  Image<float> independent(kLattice.count, 1);
  for (size_t i = 0; i < blend.size(); ++i) {
    blend.data()[i] = 0.5f * (a.data()[i] + shared.data()[i]);
    independent.data()[i] = 0.5f * (a.data()[i] + apart.data()[i]);
  }
  EXPECT_NEAR(std::sqrt(variance_of(blend)) / 1.5, 1.0, 1e-4);
  EXPECT_NEAR(std::sqrt(variance_of(independent)) / 1.5, std::sqrt(5.0) / 3.0, 0.03);  // what it would lose: 25 %
}

TEST(RealiseNoise, ABlendHasTheBlendedMagnitudes) {
  const NoiseLattice lattice{64 * 64, 1201};
  const Image<float> ring = true_spectrum(ring_power, lattice, 1.0);
  const Image<float> blob = true_spectrum(blob_power, lattice, 1.0);
  const Image<float> a = realised(ring, 1, 0);
  const Image<float> b = realised(blob, 1, 0);
  Image<float> mixed(lattice.count, 1);
  for (size_t i = 0; i < mixed.size(); ++i) mixed.data()[i] = 0.3f * ring.data()[i] + 0.7f * blob.data()[i];
  const Image<float> c = realised(mixed, 1, 0);
  for (size_t i = 0; i < c.size(); ++i)
    EXPECT_NEAR(c.data()[i], 0.3f * a.data()[i] + 0.7f * b.data()[i], 1e-5f);  // linear: S_x = Σ M_k S_k (§3.2)
}

}  // namespace
}  // namespace texbake
