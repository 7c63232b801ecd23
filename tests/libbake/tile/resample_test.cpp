#include "libbake/tile/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/libbake/color/torus_noise.h"

namespace texbake {
namespace {

// One channel of waves that repeat with the picture: `waves` periods on each axis.
Image<float> waves(int width, int height, int waves) {
  Image<float> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image(x, y) = static_cast<float>(0.5 + 0.25 * std::sin(2 * std::numbers::pi * waves * (x + 0.5) / width) +
                                       0.25 * std::cos(2 * std::numbers::pi * waves * (y + 0.5) / height));
  return image;
}

TEST(Resample, SmoothPicturesKeepTheirValuesAtTheirPlaces) {
  for (const auto& [width, height] : {std::pair(64, 64), std::pair(57, 70), std::pair(128, 30)}) {
    const Image<float> result = resample(waves(60, 66, 3), width, height, {});
    const Image<float> expected = waves(width, height, 3);
    // Lanczos-3 passes a wave of 20 texels, or of 10 new ones, to better than 1 %
    for (size_t i = 0; i < result.size(); ++i) ASSERT_NEAR(result.data()[i], expected.data()[i], 0.01);
  }
}

TEST(Resample, SameSizeIsTheSamePicture) {
  const Image<V3f> image = torus_noise(33, 20, 1, 2);
  EXPECT_EQ(resample(image, 33, 20, {}), image);
  EXPECT_EQ(resample(image, 33, 20, {Wrap::clamp, Wrap::clamp}), image);
}

TEST(Resample, ConstantStaysConstant) {
  const Image<V3f> image(37, 41, V3f(0.1f, 0.5f, 7));
  const Image<V3f> expected(64, 32, V3f(0.1f, 0.5f, 7));
  EXPECT_EQ(resample(image, 64, 32, {}), expected);
  EXPECT_EQ(resample(image, 64, 32, {Wrap::clamp, Wrap::clamp}), expected);
}

TEST(Resample, NothingOvershoots) {
  Image<float> step(40, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 10; x < 30; ++x) step(x, y) = 1;
  const Image<float> result = resample(step, 64, 48, {});
  EXPECT_EQ(*std::min_element(result.begin(), result.end()), 0);
  EXPECT_EQ(*std::max_element(result.begin(), result.end()), 1);
}

TEST(Resample, TorusHasNoBorder) {
  const Image<float> image = waves(50, 50, 2);
  const Image<float> shifted = window_of(image, {25, 0}, 50, 50);  // half a turn: a whole number of new texels
  const Image<float> result = resample(image, 64, 64, {});
  const Image<float> result_of_shifted = resample(shifted, 64, 64, {});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ASSERT_NEAR(result_of_shifted(x, y), result((x + 32) % 64, y), 1e-6);  // rounding
}

TEST(Resample, ClampedBordersDoNotMix) {
  Image<float> halves(40, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 20; x < 40; ++x) halves(x, y) = 1;
  const Image<float> clamped = resample(halves, 50, 8, {Wrap::clamp, Wrap::clamp});
  EXPECT_EQ(clamped(0, 4), 0);
  EXPECT_FLOAT_EQ(clamped(49, 4), 1);
  EXPECT_GT(resample(halves, 50, 8, {})(0, 4), 0.01f);
}

}  // namespace
}  // namespace texbake
