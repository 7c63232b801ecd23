#include "libbake/height/appearance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

constexpr int kSide = 128;

template <class Function>
Image<V3f> painted(const Function& function) {
  Image<V3f> image(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) image(x, y) = function(x, y);
  return image;
}

TEST(Appearance, AConstantPictureLooksTheSameEverywhere) {
  const AppearancePyramid pyramid(painted([](int, int) { return V3f(60, -12, 30); }));
  EXPECT_EQ(appearance_distance(pyramid.at({0, 0}).data(), pyramid.at({70, 11}).data()), 0.0f);
}

TEST(Appearance, ARampHasItsSlopeTimesSigma) {
  const AppearancePyramid pyramid(
      painted([](int x, int y) { return V3f(0.25f * static_cast<float>(x), 0, -0.5f * static_cast<float>(y)); }));
  const Appearance appearance = pyramid.at({64, 64});  // 3 σ = 48 texels away from the wrap
  for (size_t level = 0; level < kAppearanceSigmas_px.size(); ++level) {
    const auto sigma = static_cast<float>(kAppearanceSigmas_px[level]);
    const float* gradient = &appearance[12 * level + 6];
    EXPECT_NEAR(gradient[0], 0.25f * sigma, 1e-4f * sigma);  // L along x
    EXPECT_NEAR(gradient[2], 0.0f, 1e-4f * sigma);           // v* along x
    EXPECT_NEAR(gradient[5], -0.5f * sigma, 1e-4f * sigma);  // v* along y
  }
}

TEST(Appearance, DeviationIsThatOfTheGrain) {
  // Grain of standard deviation 3 in L; within 16 px there is enough of it to measure: 1 / sqrt(8 π σ²) = 1.2 %.
  Random random(3);
  const AppearancePyramid pyramid(
      painted([&](int, int) { return V3f(50 + 3 * std::sqrt(12.0f) * (random.uniform() - 0.5f), 0, 0); }));
  const Appearance appearance = pyramid.at({20, 30});
  const float* widest = &appearance[12 * (kAppearanceSigmas_px.size() - 1)];
  EXPECT_NEAR(widest[3], 3.0f, 0.15f);
  EXPECT_NEAR(widest[4], 0.0f, 1e-3f);
}

TEST(Appearance, EqualsTheSlowSumOverTheTorus) {
  Random random(4);
  const Image<V3f> image =
      painted([&](int, int) { return V3f(random.uniform(), random.uniform(), random.uniform()) * 40.0f; });
  const V2i at(3, 126);
  const std::vector<float> kernel = gaussian_kernel(4);
  const int radius = static_cast<int>(kernel.size()) / 2;
  double sum[3] = {}, square[3] = {};
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx)
      for (int c = 0; c < 3; ++c) {
        const double weight =
            static_cast<double>(kernel[static_cast<size_t>(dx + radius)]) * kernel[static_cast<size_t>(dy + radius)];
        const double value = image(wrap(at.x + dx, kSide), wrap(at.y + dy, kSide))[c];
        sum[c] += weight * value;
        square[c] += weight * value * value;
      }
  const Appearance appearance = AppearancePyramid(image).at(at);
  const float* level = &appearance[12 * 2];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(level[3 + c], std::sqrt(square[c] - sum[c] * sum[c]), 1e-3);
  // Means are counted from the mean of the picture, so only differences between places mean something.
  EXPECT_NEAR(level[0] - level[1], sum[0] - sum[1], 0.2);  // the channels' means differ by 40 / sqrt(12 · 128²) = 0.09
}

TEST(Appearance, DistanceIsTheSumOfLengths) {
  Appearance a{}, b{};
  a[0] = 3, b[1] = 4;    // means of σ = 1: length 5
  a[15] = 2;             // deviation of σ = 2
  b[18] = 1, b[23] = 1;  // gradients of σ = 2: √2
  EXPECT_FLOAT_EQ(appearance_distance(a.data(), b.data()), 5 + 2 + std::sqrt(2.0f));
  EXPECT_FLOAT_EQ(appearance_distance(a.data(), a.data()), 0);
}

}  // namespace
}  // namespace texbake
