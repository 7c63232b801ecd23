#include "libbake/content/content.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbake {
namespace {

TEST(Content, ItsMatrixTurnsBackAndEnlarges) {
  for (int eighths = 0; eighths < 8; ++eighths)
    for (const float scale : {1.0f, 0.75f, 0.671875f, 0.5f}) {
      const Content content = make_content({3, -4}, eighths, scale);
      const double angle = eighths * M_PI / 4;
      EXPECT_EQ(content.a, std::lround(65536 * std::cos(angle) / static_cast<double>(scale)));
      EXPECT_EQ(content.b, std::lround(-65536 * std::sin(angle) / static_cast<double>(scale)));
      EXPECT_EQ(content.translation, V2i(3, -4));
      EXPECT_EQ(content.impact, 0.0f);
    }
  EXPECT_EQ(make_content({0, 0}, 0, 1.0f), Content{});
}

TEST(Content, WhatIsOnlyMovedTakesTexelsAStepAway) {
  for (const V2i& d : {V2i(0, 0), V2i(7, -9), V2i(-30000, 123)})
    EXPECT_EQ(source_offset(make_content({5, -2}, 0, 1.0f), d), d + V2i(5, -2));
}

TEST(Content, AppearsTurnedClockwiseAndSmaller) {
  // A quarter of a turn, x towards y (down): what lies right of the center of the source shows below that of the patch.
  EXPECT_EQ(source_offset(make_content({0, 0}, 2, 1.0f), {0, 3}), V2i(3, 0));
  EXPECT_EQ(source_offset(make_content({0, 0}, 6, 1.0f), {0, 3}), V2i(-3, 0));
  EXPECT_EQ(source_offset(make_content({10, 20}, 4, 1.0f), {1, 3}), V2i(9, 17));
  // At half the size what lies 6 texels away shows 3 texels away.
  EXPECT_EQ(source_offset(make_content({0, 0}, 0, 0.5f), {3, -1}), V2i(6, -2));
}

TEST(Content, SourcesAreTheNearestTexels) {
  const Content content = make_content({0, 0}, 1, 0.75f);
  for (int y = -20; y <= 20; ++y)
    for (int x = -20; x <= 20; ++x) {
      const double c = std::cos(M_PI / 4) / 0.75, s = std::sin(M_PI / 4) / 0.75;
      const V2i source = source_offset(content, {x, y});
      // Half a texel, and the rounding of the matrix: 2^-17 for each of up to 40 steps.
      EXPECT_NEAR(source.x, c * x + s * y, 0.5 + 40 * std::ldexp(1.0, -17));
      EXPECT_NEAR(source.y, -s * x + c * y, 0.5 + 40 * std::ldexp(1.0, -17));
    }
}

}  // namespace
}  // namespace texbake
