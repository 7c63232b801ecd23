#include "libbake/color/sample_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "libbake/base/half.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr SampleScale kHalf{SampleCode::half, 16};
constexpr SampleScale kSrgb8{SampleCode::srgb, 8};

TEST(SampleSteps, EveryHalfFloatIsOneStepFromTheNext) {
  for (uint32_t bits = 0; bits < 0x7c00; ++bits) {
    Imath::half half;
    half.setBits(static_cast<uint16_t>(bits));
    ASSERT_EQ(in_steps(static_cast<float>(half), kHalf), static_cast<float>(bits));
    ASSERT_EQ(in_steps(-static_cast<float>(half), kHalf), -static_cast<float>(bits));
  }
  EXPECT_EQ(in_steps(std::numeric_limits<float>::infinity(), kHalf), 0x7c00) << "infinity follows the largest";
}

TEST(SampleSteps, WhatWasStoredIsWithinTheTolerance) {
  for (float value = 1e-7f; value < 60000; value *= 1.0137f) {
    const float stored = half_exact(value);
    const float toward_zero = stored > value ? half_exact(stored - std::ldexp(stored, -12)) : stored;
    EXPECT_LE(std::abs(in_steps(stored, kHalf) - in_steps(value, kHalf)), 0.5f) << value;
    EXPECT_LE(std::abs(in_steps(toward_zero, kHalf) - in_steps(value, kHalf)), default_tolerance(kHalf)) << value;
  }
}

TEST(SampleSteps, SrgbCodesAreWholeSteps) {
  for (int code = 0; code < 256; ++code)
    // 1e-4: linear_from_srgb and back round to float, 2^-24 of 255 codes each
    EXPECT_NEAR(in_steps(linear_from_srgb(static_cast<float>(code) / 255), kSrgb8), code, 1e-4);
  EXPECT_EQ(in_steps(7.0f, kSrgb8), 255) << "what is too bright to be stored is stored as white";
  EXPECT_EQ(in_steps(-1.0f, kSrgb8), 0);
}

TEST(SampleSteps, VectorsAndDataCountFromZero) {
  EXPECT_EQ(in_steps(-1.0f, {SampleCode::vector, 8}), -127);
  EXPECT_EQ(in_steps(1.0f, {SampleCode::vector, 16}), 32767);
  EXPECT_EQ(in_steps(0.5f, {SampleCode::unit, 8}), 127.5f);
}

TEST(SampleSteps, FloatsAreTheirOwnStepsAndNanStays) {
  EXPECT_EQ(in_steps(-3.25f, {}), -3.25f);
  EXPECT_EQ(default_tolerance({}), 0);
  for (const SampleScale scale : {kHalf, kSrgb8, SampleScale{}})
    EXPECT_TRUE(std::isnan(in_steps(std::numeric_limits<float>::quiet_NaN(), scale)));
}

}  // namespace
}  // namespace texbake
