#include "tests/libbake/planes/level_bias.h"

#include <gtest/gtest.h>

#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "tests/libbake/draw/small_tile.h"

namespace texbake {
namespace {

TEST(LevelBias, EveryLevelIsUnbiasedWhereTheUsualOnesAreNot) {
  SmallTile tile = random_tile({64, 64}, 5, Contents::turned, 90);
  for (V3f& c : tile.base) c *= 0.25f;  // to 0 … 1
  EvaluatorPlanes planes = tile.planes();
  const std::vector<LevelBias> biases = level_biases(planes, planes.base, 1, 3);
  ASSERT_EQ(biases.size(), 6u);
  for (const LevelBias& bias : biases) {
    EXPECT_LE(bias.unbiased.mean, 0.5 / 255) << "what was asked for";
    EXPECT_LE(bias.unbiased.worst, 1e-6) << "float sums of values up to 1";
    // 8-bit truncation loses 3/8 of a 255th with each mean of four codes, half of one when the texels become codes.
    EXPECT_NEAR(bias.truncated.signed_mean * 255, -0.5 - 0.375 * bias.level, 0.15);
  }
  // Contents of white noise are independent: where a block's center alone decides, other texels count.
  EXPECT_GT(biases[3].cheap.mean, 0.01);
}

TEST(LevelBias, WithoutPatchesCheapLevelsAreRightUpToHalfABlock) {
  Image<V3f> base(32, 32, V3f(0.5f));
  EvaluatorInput input;
  input.base = base;
  EvaluatorPlanes planes = prepare(input);
  for (const LevelBias& bias : level_biases(planes, planes.base, 1, 1)) {
    EXPECT_EQ(bias.unbiased.worst, 0);
    EXPECT_EQ(bias.cheap.worst, 0);
  }
}

}  // namespace
}  // namespace texbake
