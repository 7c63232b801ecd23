#include "libbake/draw/compare.h"

#include <gtest/gtest.h>

#include <limits>

#include "libbake/base/error.h"

namespace texbake {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Compare, EqualBitsDifferNowhere) {
  const Image<V3f> a(4, 3, V3f(0.5f)), b(4, 3, V3f(0.5f));
  const ValueComparison result = compare_values(a, b, 0);
  EXPECT_EQ(result.pixels, 12u);
  EXPECT_EQ(result.differing_pixels, 0u);
  EXPECT_EQ(result.differing_bits, 0u);
  EXPECT_FALSE(result.worst);
}

TEST(Compare, NanEqualsNothingNotEvenNan) {
  Image<V3f> a(2, 1, V3f(1)), b(2, 1, V3f(1));
  a(1, 0).y = b(1, 0).y = kNan;
  const ValueComparison result = compare_values(a, b, 1000);
  EXPECT_EQ(result.nan_pixels, 1u);
  EXPECT_EQ(result.differing_pixels, 1u);
  ASSERT_TRUE(result.worst);
  EXPECT_EQ(result.worst->x, 1);
  EXPECT_EQ(difference_picture(a, b, 1)(1, 0), V3f(1));
}

TEST(Compare, TheWorstPixelIsNamedWithBothValues) {
  Image<V3f> a(3, 3, V3f(0)), b(3, 3, V3f(0));
  b(1, 0) = V3f(0.1f, 0, 0);
  b(2, 1) = V3f(0, -0.5f, 0);
  const ValueComparison result = compare_values(a, b, 0.2f);
  EXPECT_EQ(result.differing_pixels, 1u) << "the other is within the tolerance";
  ASSERT_TRUE(result.worst);
  EXPECT_EQ(V2i(result.worst->x, result.worst->y), V2i(2, 1));
  EXPECT_EQ(result.worst->found, V3f(0, -0.5f, 0));
  EXPECT_EQ(result.worst->difference, 0.5f);
}

TEST(Compare, OneUlpIsOneBit) {
  Image<V3f> a(1, 1, V3f(1)), b(1, 1, V3f(1));
  b(0, 0).x = std::nextafter(1.0f, 2.0f);
  EXPECT_EQ(compare_values(a, b, 0).differing_bits, 1u);
}

TEST(Compare, AnotherSizeIsBadData) {
  EXPECT_THROW(compare_values(Image<V3f>(2, 2), Image<V3f>(2, 3), 0), Error);
  EXPECT_THROW(compare_decisions(Image<PixelDecision>(2, 2), Image<PixelDecision>(3, 2)), Error);
}

TEST(Compare, TheFirstDecisionThatDiffersIsNamed) {
  Image<PixelDecision> a(3, 2), b(3, 2);
  b(2, 0).content = 1;
  b(0, 1).source_y = 9;
  const DecisionComparison result = compare_decisions(a, b);
  EXPECT_EQ(result.differing_pixels, 2u);
  EXPECT_EQ(result.first, V2i(2, 0));
}

}  // namespace
}  // namespace texbake
