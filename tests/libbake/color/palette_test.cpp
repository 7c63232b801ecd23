#include "libbake/color/palette.h"

#include <gtest/gtest.h>

#include "libbake/color/luv.h"

namespace texbake {
namespace {

// Index 01, variation 0 and 10.
PrincipalVariation two_texels() {
  PrincipalVariation colors;
  colors.palette.classes = {{V3f(40, 20, 10), V3f(1, 0, 0)}, {V3f(60, -10, 30), V3f(0, 0.6f, 0.8f)}};
  colors.index = Image<uint8_t>(2, 1);
  colors.variation = Image<float>(2, 1);
  colors.index(1, 0) = 1;
  colors.variation(1, 0) = 10;
  return colors;
}

TEST(Palette, DecodesDominantPlusVariationAlongTheLine) {
  const Image<V3f> linear = decode(two_texels());
  EXPECT_EQ(linear(0, 0), linear_from_luv(V3f(40, 20, 10)));
  const V3f luv = luv_from_linear(linear(1, 0));
  EXPECT_NEAR(luv.x, 60, 1e-3);
  EXPECT_NEAR(luv.y, -4, 1e-3);
  EXPECT_NEAR(luv.z, 38, 1e-3);
}

TEST(Palette, DominantPartIgnoresTheVariation) {
  const Image<V3f> linear = decode_dominant(two_texels());
  EXPECT_EQ(linear(0, 0), linear_from_luv(V3f(40, 20, 10)));
  EXPECT_EQ(linear(1, 0), linear_from_luv(V3f(60, -10, 30)));
}

TEST(Palette, DecodedPictureHasNoNegativeLight) {
  PrincipalVariation colors = two_texels();
  colors.variation(0, 0) = -60;  // below black
  colors.variation(1, 0) = 500;  // far outside the gamut
  for (const V3f& c : decode(colors)) EXPECT_TRUE(c.x >= 0 && c.y >= 0 && c.z >= 0);
}

}  // namespace
}  // namespace texbake
