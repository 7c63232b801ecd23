#include "libbake/tile/flatten.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr int kSide = 128;

// Grain of 4 ΔE around L = 50, in CIELUV.
Image<V3f> grain() {
  Random random(4);
  Image<V3f> image(kSide, kSide);
  for (V3f& c : image) c = V3f(50.0f + 14.0f * (random.uniform() - 0.5f), 0, 0);
  return image;
}

double deviation(ImageView<const V3f> image) {
  double sum = 0, squares = 0;
  for (const V3f& c : image) {
    sum += static_cast<double>(c.x);
    squares += static_cast<double>(c.x) * static_cast<double>(c.x);
  }
  const auto n = static_cast<double>(image.size());
  return std::sqrt(squares / n - sum * sum / (n * n));
}

TEST(Flatten, OffIsTheTileItself) {
  const Image<V3f> tile = linear_from_luv(grain());
  EXPECT_EQ(flatten(tile, {}), tile);
}

TEST(Flatten, TakesShadingOutAndLeavesTheGrain) {
  Image<V3f> luv = grain();
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) luv(x, y).x += 10.0f * static_cast<float>(std::sin(2.0 * M_PI * (x + 0.5) / kSide));
  const Image<V3f> flat = luv_from_linear(flatten(linear_from_luv(luv), {.flatten_px = 12, .contrast = 0}));
  const double far_before = deviation(gaussian_blur(luv, 16.0, Wrap::repeat));
  const double far_after = deviation(gaussian_blur(flat, 16.0, Wrap::repeat));
  EXPECT_GT(far_before, 5.0);
  // The mean of σ = 12 px leaves 1 − exp(−2π² σ² / n²) = 16 % of a wave as long as the tile.
  EXPECT_LT(far_after, 0.2 * far_before);
  EXPECT_NEAR(deviation(flat), deviation(grain()), 0.1 * deviation(grain()) + 0.5);
}

TEST(Flatten, EvensOutContrast) {
  // The left half has three times the contrast of the right half.
  Image<V3f> luv = grain();
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide / 2; ++x) luv(x, y).x = 50.0f + 3.0f * (luv(x, y).x - 50.0f);
  const auto deviation_of = [](ImageView<const V3f> image, int from) {
    Image<V3f> part(kSide / 4, kSide);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide / 4; ++x) part(x, y) = image(from + x, y);
    return deviation(part);
  };
  const Image<V3f> flat = luv_from_linear(flatten(linear_from_luv(luv), {.flatten_px = 6, .contrast = 1}));
  // In the middle of each half, away from where they meet.
  const double before = deviation_of(luv, kSide / 8) / deviation_of(luv, 5 * kSide / 8);
  const double after = deviation_of(flat, kSide / 8) / deviation_of(flat, 5 * kSide / 8);
  EXPECT_NEAR(before, 3.0, 0.2);
  EXPECT_NEAR(after, 1.0, 0.15);
}

TEST(Flatten, KeepsTheMeanAndAConstant) {
  Image<V3f> tile = linear_from_luv(grain());
  const Image<V3f> flat = luv_from_linear(flatten(tile, {.flatten_px = 8, .contrast = 0.5f}));
  double mean = 0;
  for (const V3f& c : flat) mean += static_cast<double>(c.x) / static_cast<double>(flat.size());
  EXPECT_NEAR(mean, 50.0, 0.1);
  const Image<V3f> constant(32, 32, V3f(0.25f, 0.5f, 0.125f));
  for (const V3f& c : flatten(constant, {.flatten_px = 8, .contrast = 1})) {
    EXPECT_NEAR(c.x, 0.25f, 1e-5f);
    EXPECT_NEAR(c.z, 0.125f, 1e-5f);
  }
}

}  // namespace
}  // namespace texbake
