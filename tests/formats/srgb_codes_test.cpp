#include "formats/srgb_codes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "libbake/base/random.h"

namespace texbake {
namespace {

double encoded_slowly(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST(SrgbCodes, EveryCodeComesBack) {
  for (const int bits : {8, 16}) {
    const std::vector<float> linear = linear_of_srgb_codes(bits);
    const SrgbEncoder encode(bits);
    for (size_t code = 0; code < linear.size(); ++code) ASSERT_EQ(encode(linear[code]), code);
  }
}

TEST(SrgbCodes, EncodedCodeIsTheNearest) {
  Random random(1);
  for (const int bits : {8, 16}) {
    const SrgbEncoder encode(bits);
    const double highest = (1 << bits) - 1;
    for (int i = 0; i < 100000; ++i) {
      // small values as often as large ones: the curve is steep there
      const float linear = std::ldexp(random.uniform(), -static_cast<int>(random.below(24)));
      // 0.004: half an ulp of a float near 1, in steps of 1 / 65535
      ASSERT_NEAR(encode(linear), encoded_slowly(linear) * highest, 0.5 + 0.004) << linear;
    }
  }
}

TEST(SrgbCodes, EncodingNeverFalls) {
  const SrgbEncoder encode(16);
  uint16_t before = 0;
  for (float linear = 1e-8f; linear < 1.01f; linear *= 1.000003f) {
    const uint16_t code = encode(linear);
    ASSERT_GE(code, before);
    ASSERT_LE(code, before + 1) << linear;  // steps of 3e-6 skip no code
    before = code;
  }
  EXPECT_EQ(before, 65535);
}

TEST(SrgbCodes, ValuesOutsideTakeTheNearestEnd) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const SrgbEncoder encode(8);
  for (const float low : {-kInfinity, -1.0f, -0.0f, 0.0f, std::numeric_limits<float>::denorm_min()})
    EXPECT_EQ(encode(low), 0);
  for (const float high : {1.0f, 1.0001f, 100.0f, kInfinity}) EXPECT_EQ(encode(high), 255);
  EXPECT_EQ(code_from_unit(-1, 8), 0);
  EXPECT_EQ(code_from_unit(2, 16), 65535);
  EXPECT_EQ(code_from_normal(-2, 8), 1);
  EXPECT_EQ(code_from_normal(2, 8), 255);
}

TEST(SrgbCodes, DataAndNormalsRoundToTheNearestCode) {
  EXPECT_EQ(code_from_unit(0.5f, 8), 128);  // 127.5, up
  EXPECT_EQ(code_from_unit(0.499f, 8), 127);
  EXPECT_EQ(code_from_normal(0, 8), 128);
  EXPECT_EQ(code_from_normal(0, 16), 32768);
  EXPECT_EQ(code_from_normal(1, 16), 65535);
  for (int code = 0; code < 65536; ++code) {
    ASSERT_EQ(code_from_unit(static_cast<float>(code) / 65535.0f, 16), code);
    if (code > 0) {
      ASSERT_EQ(code_from_normal(normal_from_code(static_cast<uint16_t>(code), 16), 16), code);
    }
  }
}

}  // namespace
}  // namespace texbake
