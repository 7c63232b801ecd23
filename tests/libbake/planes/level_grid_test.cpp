#include "libbake/planes/level_grid.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(LevelGrid, PowersOfTwoAreHalvedDownToOneBlock) {
  const std::vector<V2i> expected = {{8, 8}, {4, 4}, {2, 2}, {1, 1}};
  EXPECT_EQ(level_grids({8, 8}), expected);
  EXPECT_EQ(level_grids({1024, 1024}).size(), 11u);
  EXPECT_EQ(level_grids({1, 1}).size(), 1u);
}

TEST(LevelGrid, AMultipleOf64GoesOnWithPowersOfTwo) {
  // 448 = 64 · 7: 7 blocks of 64 texels at level 6, then 4 of 112, 2 of 224, 1 of 448: within √2 of 128, 256, 512.
  const std::vector<V2i> grids = level_grids({448, 448});
  ASSERT_EQ(grids.size(), 10u);
  EXPECT_EQ(grids[6], V2i(7));
  EXPECT_EQ(grids[7], V2i(4));
  EXPECT_EQ(grids[8], V2i(2));
  EXPECT_EQ(grids[9], V2i(1));
}

TEST(LevelGrid, WhatCannotBeCutStaysUntilItIsOneBlock) {
  // 33 is odd: texels until 33² ≤ 2 · 4^l, which is l = 5.
  const std::vector<V2i> grids = level_grids({33, 64});
  for (size_t level = 0; level < 5; ++level) EXPECT_EQ(grids[level], V2i(33, 64 >> level)) << level;
  EXPECT_EQ(grids[5], V2i(1, 2));
  EXPECT_EQ(grids[6], V2i(1, 1));
}

TEST(LevelGrid, BlocksOfEveryLevelDivideTheTileAndAreNotAboveAStepTooLarge) {
  for (const V2i& size : {V2i(64, 1024), V2i(1472, 1088), V2i(100, 36), V2i(16384, 64)}) {
    const std::vector<V2i> grids = level_grids(size);
    EXPECT_EQ(grids.back(), V2i(1));
    for (size_t level = 1; level < grids.size(); ++level) {
      EXPECT_EQ(size.x % grids[level].x, 0);
      EXPECT_EQ(size.y % grids[level].y, 0);
      EXPECT_LE(size.x / grids[level].x, 1.42 * (1 << level));
      EXPECT_LE(size.y / grids[level].y, 1.42 * (1 << level));
    }
  }
}

}  // namespace
}  // namespace texbake
