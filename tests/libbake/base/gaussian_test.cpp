#include "libbake/base/gaussian.h"

#include <gtest/gtest.h>

#include <numeric>

namespace texbake {
namespace {

TEST(Gaussian, KernelSumsToOneAndHasItsVariance) {
  const auto kernel = gaussian_kernel(2.0);
  const int radius = static_cast<int>(kernel.size()) / 2;
  double sum = 0, variance = 0;
  for (int d = -radius; d <= radius; ++d) {
    const double weight = kernel[static_cast<size_t>(d + radius)];
    sum += weight;
    variance += weight * d * d;
  }
  EXPECT_NEAR(sum, 1.0, 1e-6);
  EXPECT_NEAR(variance, 4.0, 0.15);  // cut at three standard deviations
}

TEST(Gaussian, RepeatCarriesAcrossTheBorderAndClampDoesNot) {
  Image<float> impulse(16, 16);
  impulse(0, 8) = 1.0f;
  EXPECT_GT(gaussian_blur(impulse, 1.0, Wrap::repeat)(15, 8), 0.05f);
  EXPECT_EQ(gaussian_blur(impulse, 1.0, Wrap::clamp)(15, 8), 0.0f);
}

TEST(Gaussian, ZeroSigmaIsTheIdentity) {
  Image<float> image(5, 4, 3.0f);
  image(2, 1) = 7.0f;
  EXPECT_EQ(gaussian_blur(image, 0.0, Wrap::repeat), image);
}

}  // namespace
}  // namespace texbake
