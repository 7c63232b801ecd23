#include "libbake/segment/grow.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/libbake/segment/ascii.h"
#include "tests/libbake/segment/oracle.h"
#include "tests/libbake/segment/random_tile.h"
#include "tests/libbake/segment/slow_fragment.h"

namespace texbake {
namespace {

Image<uint8_t> classes_of(const std::string& text) {
  const auto ids = ascii_ids(text);
  Image<uint8_t> index(ids.width(), ids.height());
  for (size_t at = 0; at < ids.size(); ++at) index.data()[at] = static_cast<uint8_t>(ids.data()[at]);
  return index;
}

Image<float> values_of(const std::string& text) {
  const auto ids = ascii_ids(text);
  Image<float> v(ids.width(), ids.height());
  for (size_t at = 0; at < ids.size(); ++at) v.data()[at] = static_cast<float>(ids.data()[at]);
  return v;
}

GrowthLimits growth_limits(float threshold, int max_area_px, V2i max_extent, uint32_t seed = 1) {
  return {threshold, max_area_px, max_extent, seed};
}

TEST(Grow, EqualsItsSlowTwinOnRandomTiles) {
  for (uint32_t seed = 1; seed <= 60; ++seed) {
    const int width = 6 + static_cast<int>(seed % 9), height = 5 + static_cast<int>(seed * 7 % 11);
    const auto tile = random_tile(width, height, 1 + static_cast<int>(seed % 3), seed);
    const auto given = growth_limits(1.0f + static_cast<float>(seed % 4), 3 + static_cast<int>(seed % 20),
                                     V2i(std::max(1, width / 3), std::max(1, height / 3)), seed);
    const auto fast = grow(tile.index, tile.variation, given);
    const auto slow = slow::grow(tile.index, tile.variation, given);
    ASSERT_EQ(ascii(fast.idx), ascii(slow.idx)) << "seed " << seed;
    ASSERT_EQ(fast.seeds, slow.seeds);
  }
}

TEST(Grow, EveryTexelIsInOneConnectedFragmentOfOneClass) {
  const auto tile = random_tile(40, 30, 3, 5);
  const auto growth = grow(tile.index, tile.variation, growth_limits(4, 60, V2i(10, 7)));
  EXPECT_EQ(count_shapes(growth.idx), growth.count());
  EXPECT_EQ(count_pieces(growth.idx), growth.count());
  std::map<uint32_t, uint8_t> class_of;
  for (size_t at = 0; at < growth.idx.size(); ++at) {
    const auto [found, is_new] = class_of.try_emplace(growth.idx.data()[at], tile.index.data()[at]);
    EXPECT_EQ(found->second, tile.index.data()[at]);
  }
}

TEST(Grow, NoFragmentIsLargerThanTheLimits) {
  const auto tile = random_tile(40, 30, 1, 6);
  const auto growth = grow(tile.index, tile.variation, growth_limits(100, 50, V2i(9, 6)));
  for (uint32_t f = 0; f < static_cast<uint32_t>(growth.count()); ++f) {
    const auto texels = slow::texels_of(growth.idx, f);
    EXPECT_LE(texels.size(), 50u);
    EXPECT_TRUE(slow::fits(growth.idx, f, texels[0], V2i(9, 6)));
  }
}

TEST(Grow, NoFragmentClosesWhileABorderTexelOfItsClassIsWithinTheThreshold) {
  // With limits out of the way, what was free when a fragment closed is what later fragments took.
  const auto tile = random_tile(24, 24, 2, 9);
  const auto growth = grow(tile.index, tile.variation, growth_limits(2.5f, 10000, V2i(24, 24)));
  for (uint32_t f = 0; f < static_cast<uint32_t>(growth.count()); ++f) {
    const auto texels = slow::texels_of(growth.idx, f);
    const double mean = slow::mean_of(tile.variation, texels);
    for (const V2i& p : texels)
      for (const V2i& q : slow::neighbors(growth.idx, p)) {
        const bool was_free = growth.idx(q.x, q.y) > f;
        if (was_free && tile.index(p.x, p.y) == tile.index(q.x, q.y)) {
          EXPECT_GE(std::fabs(static_cast<double>(tile.variation(q.x, q.y)) - mean), 2.5);
        }
      }
  }
}

TEST(Grow, AStepOfTheThresholdSeparatesAndALesserOneDoesNot) {
  const auto index = classes_of("00000000 00000000 00000000 00000000 00000000 00000000");
  const auto v = values_of("11111111 11133111 11133111 11111111 11111111 11111111");
  EXPECT_EQ(grow(index, v, growth_limits(2.0f, 100, V2i(8, 6))).count(), 2) << "|3 - 1| < 2 is false";
  const auto one = grow(index, v, growth_limits(2.5f, 100, V2i(8, 6)));
  EXPECT_EQ(one.count(), 1) << "the mean lies between 1 and 3";
}

TEST(Grow, ClassesSeparateWhereVariationsAgree) {
  const auto index = classes_of("000000 011100 011100 000000");
  const auto growth = grow(index, Image<float>(6, 4, 0.0f), growth_limits(5, 100, V2i(6, 4)));
  const bool ring_first = growth.idx(0, 0) == 0;
  EXPECT_EQ(ascii(growth.idx), ring_first ? "000000 011100 011100 000000" : "111111 100011 100011 111111");
}

TEST(Grow, FeaturesCarryAcrossTheBorderOfTheTile) {
  const auto index = classes_of("110001 000000 000000 110001");
  EXPECT_EQ(grow(index, Image<float>(6, 4, 0.0f), growth_limits(5, 100, V2i(6, 4))).count(), 2);
}

TEST(Grow, ASlowRampIsFollowedByTheMeanAndCutWhereItIsLeftBehind) {
  // From any seed, the mean lags behind the ramp: a threshold of 2 cannot hold 0 and 9 together.
  const auto index = classes_of("0000000000 0000000000 0000000000");
  const auto v = values_of("0123456789 0123456789 0123456789");
  const auto growth = grow(index, v, growth_limits(2, 100, V2i(10, 3)));
  EXPECT_GE(growth.count(), 3);
  EXPECT_LE(growth.count(), 6);
}

TEST(Grow, AnotherSeedGivesAnotherMapAndTheSameSeedTheSame) {
  const auto tile = random_tile(32, 32, 3, 2);
  const auto a = grow(tile.index, tile.variation, growth_limits(2, 40, V2i(8, 8), 1));
  EXPECT_EQ(a.idx, grow(tile.index, tile.variation, growth_limits(2, 40, V2i(8, 8), 1)).idx);
  EXPECT_NE(a.idx, grow(tile.index, tile.variation, growth_limits(2, 40, V2i(8, 8), 2)).idx);
}

}  // namespace
}  // namespace texbake
