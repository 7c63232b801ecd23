#include "libbake/noise/synthesis_test.h"

#include <gtest/gtest.h>

#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

TEST(EnergyDeviation, IsZeroForTheSameImageAndForAnotherContrast) {
  const Image<float> image = synthetic_noise(ring_power, 64, 0.01, 1);
  EXPECT_EQ(energy_deviation(image, image), 0.0);
  Image<float> stronger = image.clone();
  for (float& value : stronger) value *= 3.0f;
  EXPECT_NEAR(energy_deviation(image, stronger), 0.0, 1e-3);  // the deviation sees where, not how much
}

TEST(EnergyDeviation, SeesGrainInTheWrongPlace) {
  const Image<float> grain = synthetic_noise(ring_power, 64, 0.01, 1);
  const Image<float> other = synthetic_noise(ring_power, 64, 0.01, 2);
  Image<float> left = grain.clone();
  for (int y = 0; y < 64; ++y)
    for (int x = 32; x < 64; ++x) left(x, y) *= 0.1f;
  EXPECT_LT(energy_deviation(grain, other), 0.5);
  EXPECT_GT(energy_deviation(grain, left), 1.0);
}

TEST(MeanCoherence, IsHighForLinesAndLowForGrain) {
  Image<float> lines(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) lines(x, y) = static_cast<float>(std::sin(2.0 * M_PI * (4 * x + 4 * y) / 64.0));
  EXPECT_NEAR(mean_coherence(lines), 1.0, 1e-4);
  EXPECT_LT(mean_coherence(white_noise(64, 1)), 0.35);
  EXPECT_EQ(mean_coherence(Image<float>(16, 16, 0.5f)), 0.0);
}

}  // namespace
}  // namespace texbake
