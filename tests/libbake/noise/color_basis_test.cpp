#include "libbake/noise/color_basis.h"

#include <gtest/gtest.h>

#include "libbake/base/random.h"

namespace texbake {
namespace {

const V3f kLong(0.8f, 0.6f, 0.0f);
const V3f kMiddle(-0.6f, 0.8f, 0.0f);
const V3f kShort(0.0f, 0.0f, 1.0f);

Image<V3f> cloud(float a, float b, float c) {
  Random random(4);
  Image<V3f> colors(64, 64);
  for (V3f& color : colors)
    color = V3f(0.1f, 0.2f, 0.3f) + kLong * (a * (random.uniform() - 0.5f)) +
            kMiddle * (b * (random.uniform() - 0.5f)) + kShort * (c * (random.uniform() - 0.5f));
  return colors;
}

TEST(PrincipalBasis, FindsTheAxesByFallingVariance) {
  const ColorBasis basis = principal_basis(cloud(1.0f, 0.3f, 0.1f), Image<uint8_t>(64, 64, 1));
  EXPECT_GT(basis.axis[0].dot(kLong), 0.999f);
  EXPECT_GT(basis.axis[1].dot(kMiddle), 0.999f);
  EXPECT_GT(basis.axis[2].dot(kShort), 0.999f);
  EXPECT_NEAR((basis.mean - V3f(0.1f, 0.2f, 0.3f)).length(), 0.0f, 0.02f);  // 3 standard errors of 4096 values
}

TEST(PrincipalBasis, IsOrthonormalAndInvertible) {
  const ColorBasis basis = principal_basis(cloud(0.2f, 0.5f, 0.4f), Image<uint8_t>(64, 64, 1));
  for (size_t a = 0; a < 3; ++a)
    for (size_t b = 0; b < 3; ++b) EXPECT_NEAR(basis.axis[a].dot(basis.axis[b]), a == b ? 1.0f : 0.0f, 1e-6f);
  const V3f color(0.7f, 0.1f, 0.4f);
  EXPECT_NEAR((basis.color(basis.channels(color)) - color).length(), 0.0f, 1e-6f);
}

TEST(PrincipalBasis, SeesOnlyTheMask) {
  Image<V3f> colors = cloud(1.0f, 0.3f, 0.1f);
  Image<uint8_t> mask(64, 64, 1);
  colors(3, 3) = V3f(0, 0, 1000);
  mask(3, 3) = 0;
  EXPECT_GT(principal_basis(colors, mask).axis[0].dot(kLong), 0.999f);
}

TEST(PrincipalBasis, OfOneColorIsRgb) {
  const ColorBasis basis = principal_basis(Image<V3f>(8, 8, V3f(0.5f)), Image<uint8_t>(8, 8, 1));
  EXPECT_EQ(basis.axis[0], V3f(1, 0, 0));
  EXPECT_EQ(basis.mean, V3f(0.5f));
}

TEST(MatchAxes, PutsLikeWithLikeAndTurnsThemRound) {
  const ColorBasis reference{V3f(0), {kLong, kMiddle, kShort}};
  const ColorBasis other{V3f(1), {-kShort, kLong, -kMiddle}};
  const ColorBasis matched = match_axes(other, reference);
  EXPECT_EQ(matched.axis[0], kLong);
  EXPECT_EQ(matched.axis[1], kMiddle);
  EXPECT_EQ(matched.axis[2], kShort);
  EXPECT_EQ(matched.mean, V3f(1));
}

}  // namespace
}  // namespace texbake
