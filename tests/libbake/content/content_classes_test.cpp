#include "libbake/content/content_classes.h"

#include <gtest/gtest.h>

#include "libbake/color/luv.h"

namespace texbake {
namespace {

// Classes 0 and 2 of a palette of three, of one color each, v constant but for a spot in class 2 that stands out.
struct ClassesFixture {
  ClassesFixture() : base(64, 64, V3f(0.2f, 0.3f, 0.1f)) {
    colors.palette.classes.resize(3);
    colors.index = Image<uint8_t>(64, 64);
    colors.variation = Image<float>(64, 64);
    for (int y = 0; y < 64; ++y)
      for (int x = 32; x < 64; ++x) {
        colors.index(x, y) = 2;
        base(x, y) = V3f(0.7f, 0.6f, 0.5f);
      }
    for (int y = 20; y < 28; ++y)
      for (int x = 44; x < 52; ++x) {
        colors.variation(x, y) = 9.0f;
        base(x, y) = V3f(0.9f, 0.9f, 0.9f);
      }
  }
  PrincipalVariation colors;
  Image<V3f> base;
};

TEST(ContentClasses, AreDominantColorsSplitBySaliencyWithoutEmptyOnes) {
  const ClassesFixture f;
  const ContentClasses classes = content_classes(f.colors, f.base);
  ASSERT_EQ(classes.count(), 3);  // class 0, class 2, the salient part of class 2
  EXPECT_EQ(classes.idx(10, 10), 0);
  EXPECT_EQ(classes.idx(36, 50), 1);
  EXPECT_EQ(classes.idx(48, 24), 2);
  EXPECT_NEAR(classes.salient_share, 64.0 / 4096.0, 1e-12);
}

TEST(ContentClasses, HaveTheMeanColorsOfTheirTexels) {
  const ClassesFixture f;
  const ContentClasses classes = content_classes(f.colors, f.base);
  const V3f expected[] = {luv_from_linear(V3f(0.2f, 0.3f, 0.1f)), luv_from_linear(V3f(0.7f, 0.6f, 0.5f)),
                          luv_from_linear(V3f(0.9f, 0.9f, 0.9f))};
  for (size_t j = 0; j < 3; ++j)
    EXPECT_LT((classes.mean_luv[j] - expected[j]).length(), 1e-4f);  // the rounding of floats near 100
}

}  // namespace
}  // namespace texbake
