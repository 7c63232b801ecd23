#include "libbake/content/saliency.h"

#include <gtest/gtest.h>

#include "libbake/base/random.h"

namespace texbake {
namespace {

constexpr int kSalientSize = 128;

// Fine grain of v around 0 in every class, with a blob of v = 20 at `odd`, 12 texels wide, in class 0.
PrincipalVariation grain_with_odd_blob(V2i odd) {
  PrincipalVariation colors;
  colors.palette.classes.resize(2);
  colors.index = Image<uint8_t>(kSalientSize, kSalientSize);
  colors.variation = Image<float>(kSalientSize, kSalientSize);
  Random random(3);
  for (int y = 0; y < kSalientSize; ++y)
    for (int x = 0; x < kSalientSize; ++x) {
      colors.index(x, y) = x % 32 < 8 ? 1 : 0;
      colors.variation(x, y) = 4.0f * random.uniform() - 2.0f;
    }
  for (int y = -6; y < 6; ++y)
    for (int x = -6; x < 6; ++x) {
      const V2i p = wrap(odd + V2i(x, y), V2i(kSalientSize, kSalientSize));
      colors.index(p.x, p.y) = 0;
      colors.variation(p.x, p.y) = 20.0f;
    }
  return colors;
}

class SaliencyOfAnOddBlob : public ::testing::TestWithParam<V2i> {};

TEST_P(SaliencyOfAnOddBlob, IsTheGreatestAndAboveTheThreshold) {
  const V2i odd = GetParam();
  const PrincipalVariation colors = grain_with_odd_blob(odd);
  const Image<float> salient = saliency(colors);
  const float threshold = two_class_threshold(salient);
  int others = 0;
  for (int y = 0; y < kSalientSize; ++y)
    for (int x = 0; x < kSalientSize; ++x) {
      EXPECT_GE(salient(x, y), 0.0f);
      EXPECT_LE(salient(x, y), 1.0f);
      const V2i d = shortest(V2i(x, y) - odd, V2i(kSalientSize, kSalientSize));
      if (d.x >= -6 && d.x < 6 && d.y >= -6 && d.y < 6)
        EXPECT_GT(salient(x, y), threshold) << x << ' ' << y;
      else
        others += salient(x, y) > threshold;
    }
  EXPECT_EQ(others, 0);
}

INSTANTIATE_TEST_SUITE_P(Places, SaliencyOfAnOddBlob,
                         ::testing::Values(V2i(50, 60), V2i(0, 0), V2i(127, 64)));  // also across border and corner

TEST(Saliency, IsNothingWhereVariationIsConstant) {
  PrincipalVariation colors;
  colors.palette.classes.resize(1);
  colors.index = Image<uint8_t>(40, 24);
  colors.variation = Image<float>(40, 24, 3.0f);
  for (const float s : saliency(colors)) EXPECT_EQ(s, 0.0f);
}

TEST(Saliency, AnElementOfWhichThereAreManyIsLessSalientThanALonelyOne) {
  PrincipalVariation colors = grain_with_odd_blob({20, 20});
  // The same v, 20, at the far corners of a lattice in a copy: common, so spread over the tile.
  PrincipalVariation common = grain_with_odd_blob({20, 20});
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
          common.index(32 * i + 12 + x, 32 * j + 16 + y) = 0;
          common.variation(32 * i + 12 + x, 32 * j + 16 + y) = 20.0f;
        }
  // Against one that is odd in the other direction, and alone.
  for (PrincipalVariation* both : {&colors, &common})
    for (int y = 92; y < 104; ++y)
      for (int x = 76; x < 88; ++x) {
        both->index(x, y) = 0;
        both->variation(x, y) = -20.0f;
      }
  const auto relative = [](const Image<float>& s) { return s(20, 20) / s(82, 98); };
  EXPECT_LT(relative(saliency(common)), 0.5f * relative(saliency(colors)));
}

TEST(TwoClassThreshold, SplitsTwoHeaps) {
  Image<float> values(100, 1, 0.2f);
  for (int x = 0; x < 10; ++x) values(x, 0) = 0.8f;
  const float threshold = two_class_threshold(values);
  EXPECT_GT(threshold, 0.2f);
  EXPECT_LT(threshold, 0.8f);
}

TEST(TwoClassThreshold, IsOneWhereAllIsAlike) { EXPECT_EQ(two_class_threshold(Image<float>(9, 9, 0.5f)), 1.0f); }

}  // namespace
}  // namespace texbake
