#include "libbake/color/luv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/random.h"

namespace texbake {
namespace {

void expect_near(const V3f& actual, const V3f& expected, float tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

TEST(Luv, PrimariesHaveTheirTabulatedCoordinates) {
  // Published CIELUV coordinates of the sRGB primaries. Tables differ by 0.02 with the digits kept of the D65 white:
  // XYZ (0.95047, 1, 1.08883) or, as here, the standard's chromaticity (0.3127, 0.3290).
  expect_near(luv_from_linear(V3f(1, 0, 0)), {53.24f, 175.01f, 37.75f}, 0.02f);
  expect_near(luv_from_linear(V3f(0, 1, 0)), {87.73f, -83.08f, 107.40f}, 0.02f);
  expect_near(luv_from_linear(V3f(0, 0, 1)), {32.30f, -9.40f, -130.34f}, 0.02f);
}

TEST(Luv, WhiteIsHundredAndBlackIsZero) {
  expect_near(luv_from_linear(V3f(1, 1, 1)), {100, 0, 0}, 1e-5f);
  EXPECT_EQ(luv_from_linear(V3f(0)), V3f(0));
  EXPECT_EQ(linear_from_luv(V3f(0)), V3f(0));
}

TEST(Luv, GraysHaveNoChroma) {
  for (const float gray : {1e-4f, 0.01f, 0.18f, 0.5f, 2.0f}) {
    const V3f luv = luv_from_linear(V3f(gray));
    EXPECT_NEAR(luv.y, 0, 1e-9f);  // double rounding only
    EXPECT_NEAR(luv.z, 0, 1e-9f);
  }
}

TEST(Luv, MiddleGrayIsTakenFromLinearLight) {
  // 18.42 % reflects half the lightness: ((50 + 16) / 116)³.
  EXPECT_NEAR(luv_from_linear(V3f(0.18418651851f)).x, 50, 1e-4f);
}

TEST(Luv, RoundTripsInsideTheGamut) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const float scale = i % 2 ? 1.0f : 0.005f;  // both branches of the lightness
    const V3f c(scale * random.uniform(), scale * random.uniform(), scale * random.uniform());
    expect_near(linear_from_luv(luv_from_linear(c)), c, 1e-5f * scale);  // a few float steps of L, u*, v*
  }
}

TEST(Luv, RoundTripsAboveOneAndBelowZero) {
  for (const V3f& c : {V3f(4, 0.5f, 2), V3f(-0.05f, 0.4f, 0.1f), V3f(-0.2f, -0.3f, -0.1f), V3f(0.9f, -0.1f, 1.5f)})
    expect_near(linear_from_luv(luv_from_linear(c)), c, 1e-5f * 4);
}

TEST(Luv, ExtremeChromaOfADarkColorStaysFinite) {
  const V3f c = linear_from_luv(V3f(1e-6f, 20, -30));
  EXPECT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z));
}

TEST(Luv, ImageIsItsTexels) {
  Image<V3f> image(3, 2);
  for (int i = 0; i < 6; ++i) image.data()[i] = V3f(0.1f * static_cast<float>(i), 0.3f, 0.05f);
  const Image<V3f> luv = luv_from_linear(image.view());
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(luv.data()[i], luv_from_linear(image.data()[i]));
  const Image<V3f> back = linear_from_luv(luv.view());
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(back.data()[i], linear_from_luv(luv.data()[i]));
}

TEST(Srgb, CurveHasItsKnownValues) {
  EXPECT_NEAR(linear_from_srgb(0.5f), 0.21404114048, 1e-8);
  EXPECT_NEAR(linear_from_srgb(0.04f), 0.04 / 12.92, 1e-9);
  EXPECT_NEAR(srgb_from_linear(0.18f), 0.46135612950, 3e-8);  // one float step near ½
}

TEST(Srgb, KeepsZeroAndOneAndIsOdd) {
  EXPECT_EQ(linear_from_srgb(0), 0);
  EXPECT_EQ(srgb_from_linear(0), 0);
  EXPECT_EQ(linear_from_srgb(1), 1);
  EXPECT_EQ(srgb_from_linear(1), 1);
  for (const float x : {0.002f, 0.2f, 0.7f, 1.3f}) {
    EXPECT_EQ(linear_from_srgb(-x), -linear_from_srgb(x));
    EXPECT_EQ(srgb_from_linear(-x), -srgb_from_linear(x));
  }
}

TEST(Srgb, EveryByteAndEveryShortRoundTrips) {
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_EQ(std::lround(255.0 * srgb_from_linear(linear_from_srgb(static_cast<float>(byte) / 255.0f))), byte);
  for (int word = 0; word < 65536; word += 7)
    EXPECT_EQ(std::lround(65535.0 * srgb_from_linear(linear_from_srgb(static_cast<float>(word) / 65535.0f))), word);
}

TEST(Srgb, AgreesWithThePowerFunction) {
  for (float x = 0.004f; x < 4; x *= 1.1f)
    EXPECT_NEAR(srgb_from_linear(x), 1.055 * std::pow(static_cast<double>(x), 1 / 2.4) - 0.055, 1e-7 * (1 + x));
}

}  // namespace
}  // namespace texbake
