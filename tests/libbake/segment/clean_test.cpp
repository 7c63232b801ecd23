#include "libbake/segment/clean.h"

#include <gtest/gtest.h>

#include "tests/libbake/segment/ascii.h"
#include "tests/libbake/segment/oracle.h"
#include "tests/libbake/segment/random_tile.h"
#include "tests/libbake/segment/slow_fragment.h"

namespace texbake {
namespace {

/// A growth that left the drawn fragments; the seed of each is its first texel.
Growth growth_of(const std::string& text) {
  Growth growth;
  growth.idx = ascii_ids(text);
  for (uint32_t f = 0; f < static_cast<uint32_t>(count_shapes(growth.idx)); ++f) {
    const V2i first = slow::texels_of(growth.idx, f).front();
    growth.seeds.push_back(static_cast<size_t>(first.y * growth.idx.width() + first.x));
  }
  return growth;
}

/// Gray of lightness 10 × the digit.
Image<V3f> grays(const std::string& text) {
  const auto ids = ascii_ids(text);
  Image<V3f> luv(ids.width(), ids.height());
  for (size_t at = 0; at < ids.size(); ++at) luv.data()[at] = V3f(10.0f * static_cast<float>(ids.data()[at]), 0, 0);
  return luv;
}

CleaningLimits limits(int min_area_px, int max_area_px = 1000, V2i max_extent = V2i(1000, 1000)) {
  return {min_area_px, max_area_px, max_extent};
}

TEST(Clean, EqualsItsSlowTwinOnRandomTiles) {
  for (uint32_t seed = 1; seed <= 60; ++seed) {
    const int width = 6 + static_cast<int>(seed % 9), height = 5 + static_cast<int>(seed * 7 % 11);
    const auto tile = random_tile(width, height, 1 + static_cast<int>(seed % 3), seed);
    const V2i extent(std::max(1, width / 3), std::max(1, height / 3));
    const auto growth = [&] { return grow(tile.index, tile.variation, {2.0f, 14, extent, seed}); };
    const auto given = limits(2 + static_cast<int>(seed % 9), 14, extent);
    const auto luv = luv_of(tile);
    ASSERT_EQ(ascii(clean(growth(), luv, given).idx), ascii(slow::clean(growth(), luv, given))) << "seed " << seed;
  }
}

TEST(Clean, FragmentsStayConnectedAndSeedsStayInside) {
  const auto tile = random_tile(48, 40, 3, 4);
  const V2i extent(11, 9);
  const auto result = clean(grow(tile.index, tile.variation, {2, 80, extent, 1}), luv_of(tile), limits(12, 80, extent));
  EXPECT_EQ(count_pieces(result.idx), result.count());
  EXPECT_EQ(count_shapes(result.idx), result.count());
  for (uint32_t f = 0; f < static_cast<uint32_t>(result.count()); ++f) {
    EXPECT_EQ(result.idx.data()[result.seeds[f]], f);
    EXPECT_GE(slow::texels_of(result.idx, f).size(), 12u);
    EXPECT_TRUE(slow::fits(result.idx, f, slow::texels_of(result.idx, f)[0], extent));
  }
}

TEST(Clean, SpecksGoToTheNeighborOfNearestColor) {
  EXPECT_EQ(ascii(clean(growth_of("000111 020131 000111"), grays("222888 272838 222888"), limits(2)).idx),
            "000111 000111 000111")
      << "an enclosed speck has one neighbour, whatever its colour";
  EXPECT_EQ(ascii(clean(growth_of("000111 002111 000111"), grays("222888 227888 222888"), limits(2)).idx),
            "000111 001111 000111");
  EXPECT_EQ(ascii(clean(growth_of("000111 002111 000111"), grays("222888 223888 222888"), limits(2)).idx),
            "000111 000111 000111");
}

TEST(Clean, AnEmptiedFragmentIsDividedAmongItsNeighborsTexelByTexel) {
  EXPECT_EQ(ascii(clean(growth_of("00022111 00022111 00022111"), grays("22237888 22237888 22237888"), limits(7)).idx),
            "00001111 00001111 00001111");
}

TEST(Clean, ReachesTheMiddleOfAFragmentFromItsBorder) {
  const auto result = clean(growth_of("0000000 0111110 0111110 0111110 0111110 0000000"),
                            grays("2222222 2888882 2888882 2888882 2888882 2222222"), limits(21));
  EXPECT_EQ(result.count(), 1);
}

TEST(Clean, TheSmallestIsEmptiedFirst) {
  // Emptied first, the single texel 2 makes 1 large enough to stay; the other way round 1 would be dissolved too.
  EXPECT_EQ(ascii(clean(growth_of("00000 01120 00000"), grays("22222 28862 22222"), limits(3)).idx),
            "00000 01110 00000");
}

TEST(Clean, AMinimumOfOneChangesNothingButTheNumbers) {
  EXPECT_EQ(ascii(clean(growth_of("2201 2201"), grays("2222 2222"), limits(1)).idx), "0012 0012");
}

TEST(Clean, AFullNeighborTakesATexelOnlyWhereNoOtherCan) {
  const auto colors = grays("222288 222288 222388");
  EXPECT_EQ(ascii(clean(growth_of("000011 000011 000211"), colors, limits(2, 12)).idx), "000011 000011 000011");
  EXPECT_EQ(ascii(clean(growth_of("000011 000011 000211"), colors, limits(2, 11)).idx), "000011 000011 000111");
  EXPECT_EQ(ascii(clean(growth_of("0000 0100 0000"), grays("2222 2822 2222"), limits(2, 11)).idx), "0000 0000 0000");
}

TEST(Clean, WhatNoNeighborCanTakeStays) {
  const auto result =
      clean(growth_of("001100 001100 001120 001100"), grays("227722 227722 227742 227722"), limits(2, 1000, V2i(2, 4)));
  EXPECT_EQ(ascii(result.idx), "001100 001100 001120 001100")
      << "1 would become 3 wide, and 0, which lies across the border, is 4 wide already";
}

}  // namespace
}  // namespace texbake
