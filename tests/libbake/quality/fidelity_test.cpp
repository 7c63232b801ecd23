#include "libbake/quality/fidelity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "libbake/base/fft.h"
#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

Image<V3f> grain(int n, double sigma_px, uint32_t seed) {
  Random random(seed);
  Image<V3f> image(n, n);
  for (V3f& c : image) c = V3f(random.uniform(), random.uniform(), random.uniform()) * 100.0f;
  return gaussian_blur(image, sigma_px, Wrap::repeat);
}

TEST(Fidelity, AnExemplarMatchesItself) {
  const Image<V3f> image = grain(64, 1.0, 1);
  EXPECT_EQ(*color_distance(image, image), 0.0);
  EXPECT_EQ(*spectrum_distance_db(image, image), 0.0);
  EXPECT_EQ(gradient_match(image, image)->ratio_of_means, 1.0);
  EXPECT_EQ(*structure_distance(image, image, image), 1.0);
  for (const auto& ratio : octave_band_ratios(image, image)) EXPECT_EQ(*ratio, 1.0);
}

TEST(Fidelity, BlurMovesGradientsAndSpectrumAndFineBands) {
  const Image<V3f> image = grain(128, 1.0, 1);
  const Image<V3f> blurred = gaussian_blur(image, 1.5, Wrap::repeat);
  EXPECT_LT(gradient_match(image, blurred)->ratio_of_means, 0.7);
  EXPECT_GT(*spectrum_distance_db(image, blurred), 3.0);
  EXPECT_LT(*octave_band_ratios(image, blurred).front(), 0.85);
  EXPECT_NEAR(*octave_band_ratios(image, blurred)[3], 1.0, 0.1);  // the blur is far below this band
}

TEST(Fidelity, HalfTheContrastIsSixDecibels) {
  const Image<V3f> image = grain(64, 1.0, 1);
  Image<V3f> flat = image.clone();
  for (V3f& c : flat) c *= 0.5f;
  EXPECT_NEAR(*spectrum_distance_db(image, flat), 6.02, 0.01);
  EXPECT_NEAR(gradient_match(image, flat)->ratio_of_means, 0.5, 1e-6);
}

TEST(Fidelity, ColorDistanceIsAShiftInUnitsOfTheDeviation) {
  const Image<V3f> image = grain(64, 0.0, 1);  // uniform in a cube of 100: deviation 100 · sqrt(3/12) = 50
  Image<V3f> shifted = image.clone();
  for (V3f& c : shifted) c.x += 10.0f;
  // Over the sphere the mean of cos² is 1/3: 10 / sqrt(3) / 50.
  EXPECT_NEAR(*color_distance(image, shifted), 0.1155, 0.004);
}

TEST(Fidelity, ShuffledTexelsHaveStructureNowhereFound) {
  const Image<V3f> image = grain(128, 2.0, 1);
  Image<V3f> shuffled = image.clone();
  Random random(7);
  for (size_t i = shuffled.size() - 1; i > 0; --i)
    std::swap(shuffled.data()[i], shuffled.data()[random.below(static_cast<uint32_t>(i + 1))]);
  EXPECT_GT(*structure_distance(image, shuffled, image), 1.3);
}

TEST(Fidelity, RandomPhasesKeepTheSpectrumAndLoseTheStructure) {
  // Sparse bright squares: nothing Gaussian about them.
  Random random(5);
  Image<V3f> image(128, 128, V3f(20, 0, 0));
  for (int i = 0; i < 40; ++i) {
    const int x0 = static_cast<int>(random.below(120)), y0 = static_cast<int>(random.below(120));
    for (int y = y0; y < y0 + 8; ++y)
      for (int x = x0; x < x0 + 8; ++x) image(x, y).x = 90;
  }
  // Random phases of white noise, amplitudes of the exemplar: the same power at every frequency.
  Image<float> lightness(128, 128), noise(128, 128);
  for (size_t i = 0; i < image.size(); ++i) lightness.data()[i] = image.data()[i].x;
  for (float& value : noise) value = random.uniform() - 0.5f;
  auto spectrum = fft<float>(lightness.view());
  const auto phases = fft<float>(noise.view());
  for (size_t i = 1; i < spectrum.size(); ++i)
    spectrum.data()[i] = phases.data()[i] / std::abs(phases.data()[i]) * std::abs(spectrum.data()[i]);
  const Image<float> scrambled = inverse_fft_real<float>(spectrum.view());
  Image<V3f> rendering(128, 128);
  for (size_t i = 0; i < image.size(); ++i) rendering.data()[i] = V3f(scrambled.data()[i], 0, 0);

  EXPECT_LT(*spectrum_distance_db(image, rendering), 2.0);  // periodograms of nine windows: chance alone gives one
  EXPECT_GT(*structure_distance(image, rendering, image), 1.5);
  EXPECT_GT(*color_distance(image, rendering), 0.2);
}

TEST(Fidelity, BandsTellWhichSizeLostItsContrast) {
  // Grain of about 1/64 and shapes of about 1/4 of the side; the shapes are halved.
  const Image<V3f> fine = grain(128, 1.0, 1);
  Image<V3f> coarse = grain(128, 16.0, 2);
  for (V3f& c : coarse) c = (c - V3f(50)) * 20.0f;
  Image<V3f> image(128, 128), flatter(128, 128);
  for (size_t i = 0; i < image.size(); ++i) {
    image.data()[i] = fine.data()[i] + coarse.data()[i];
    flatter.data()[i] = fine.data()[i] + coarse.data()[i] * 0.5f;
  }
  const auto ratios = octave_band_ratios(image, flatter);
  ASSERT_EQ(ratios.size(), 5u);
  EXPECT_NEAR(*ratios.front(), 1.0, 0.05);
  EXPECT_NEAR(*ratios.back(), 0.5, 0.05);
}

TEST(Fidelity, IsNotDefinedForAConstantExemplar) {
  const Image<V3f> flat(32, 32, V3f(40, 1, 1));
  EXPECT_FALSE(color_distance(flat, flat).has_value());
  EXPECT_FALSE(spectrum_distance_db(flat, flat).has_value());
  EXPECT_FALSE(gradient_match(flat, flat).has_value());
  EXPECT_FALSE(structure_distance(flat, flat, flat).has_value());
}

}  // namespace
}  // namespace texbake
