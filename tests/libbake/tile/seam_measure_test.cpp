#include "libbake/tile/seam_measure.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "libbake/color/luv.h"
#include "tests/libbake/color/torus_noise.h"

namespace texbake {
namespace {

TEST(SeamMeasure, ToriTileAndTheirCropsDoNot) {
  const Image<V3f> torus = torus_noise(128, 96, 3, 1);
  const SeamMeasure whole = measure_seam(torus);
  EXPECT_NEAR(whole.x.ratio, 1, 0.15);  // 96 pairs of a smooth field
  EXPECT_NEAR(whole.y.ratio, 1, 0.15);
  EXPECT_TRUE(whole.tiles());
  const SeamMeasure crop = measure_seam(window_of(torus, {5, 7}, 100, 80));
  EXPECT_GT(crop.x.ratio, 2);
  EXPECT_GT(crop.y.ratio, 2);
  EXPECT_FALSE(crop.x.tiles());
  EXPECT_FALSE(crop.y.tiles());
}

TEST(SeamMeasure, AxesAreJudgedApart) {
  const Image<V3f> torus = torus_noise(128, 96, 3, 1);
  const SeamMeasure only_x = measure_seam(window_of(torus, {0, 0}, 128, 60));
  EXPECT_TRUE(only_x.x.tiles());
  EXPECT_FALSE(only_x.y.tiles());
}

TEST(SeamMeasure, RatioIsTheStepAcrossTheWrapOverTheMeanStep) {
  // columns 0, 1, 3, 0: steps 1, 2, 3, and 0 across the wrap; then 0, 1, 3, 9: wrap 9 against 1, 2, 6
  Image<float> rows(4, 2);
  const float values[] = {0, 1, 3, 9};
  for (int y = 0; y < 2; ++y) std::copy(values, values + 4, rows.row(y));
  const SeamMeasure seam = measure_seam(rows);
  EXPECT_DOUBLE_EQ(seam.x.ratio, 9 / 3.0);
  EXPECT_DOUBLE_EQ(seam.x.share_of_largest, 9 / 6.0);
  EXPECT_DOUBLE_EQ(seam.x.share_of_beside, 9 / 6.0);
  EXPECT_DOUBLE_EQ(seam.y.ratio, 1);  // constant along y
}

TEST(SeamMeasure, BlockEdgesAreComparedWithBlockEdges) {
  // Every 8 columns the shade jumps by 0.1, as in a coarse JPEG: across the wrap too. Inside a block it drifts by 0.01.
  Image<V3f> blocks(64, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 64; ++x) {
      const float code = 0.3f + (x / 8 % 2 ? 0.1f : 0.0f) + 0.01f * static_cast<float>(x % 8 < 4 ? x % 4 : 3 - x % 4);
      blocks(x, y) = V3f(linear_from_srgb(code));
    }
  EXPECT_NEAR(measure_seam(blocks).x.ratio, 1, 1e-3);
}

TEST(SeamMeasure, AnEdgeAlongTheWrapTilesWhereOthersAreAsStrong) {
  // Stripes of two soft-edged colors; the wrap falls into the middle of an edge.
  Image<V3f> stripes(96, 32);
  const float profile[] = {0.6f, 0.8f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.9f, 0.8f, 0.6f,
                           0.4f, 0.2f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.2f, 0.4f};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 96; ++x) stripes(x, y) = V3f(linear_from_srgb(profile[x % 24]));
  const SeamMeasure whole = measure_seam(stripes);
  EXPECT_GT(whole.x.ratio, kLargestSeamRatio);
  EXPECT_TRUE(whole.x.tiles());
  // Cut in the middle of a stripe instead, black meets white: as strong a step, but nothing leads up to it.
  EXPECT_FALSE(measure_seam(window_of(stripes, {6, 0}, 84, 32)).x.tiles());
}

TEST(SeamMeasure, ConstantPicturesTile) {
  EXPECT_TRUE(measure_seam(Image<V3f>(40, 40, V3f(0.2f))).tiles());
  EXPECT_TRUE(measure_seam(Image<float>(1, 1, 0.2f)).tiles());
}

TEST(SeamMeasure, ASlopeDoesNotTile) {
  Image<float> slope(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) slope(x, y) = static_cast<float>(x) / 64;
  EXPECT_FALSE(measure_seam(slope).x.tiles());
  EXPECT_TRUE(measure_seam(slope).y.tiles());
}

}  // namespace
}  // namespace texbake
