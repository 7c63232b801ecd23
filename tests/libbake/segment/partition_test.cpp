#include "libbake/segment/partition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/base/random.h"
#include "tests/libbake/segment/ascii.h"
#include "tests/libbake/segment/oracle.h"

namespace texbake {
namespace {

using testing::HasSubstr;

std::string unwrap_error(const std::string& ids) {
  try {
    unwrap(ascii_ids(ids));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    return error.what();
  }
  return "";
}

/// 3×3 blocks on a 9×9 torus, one across the corner: every partition into boxes under half the tile.
Partition blocks() {
  return unwrap(
      ascii_ids("011122200 "
                "344455533 "
                "344455533 "
                "344455533 "
                "677788866 "
                "677788866 "
                "677788866 "
                "011122200 "
                "011122200"));
}

TEST(Partition, ShapesInsideTheTileHaveNoOffset) {
  const auto partition = blocks();
  for (int y = 1; y < 7; ++y)
    for (int x = 1; x < 7; ++x) EXPECT_EQ(partition.owner(x, y), (OwnerOffset{0, 0}));
  EXPECT_EQ(partition.centers[4], V2i(2, 2));
  EXPECT_EQ(partition.centers[8], V2i(5, 5));
}

TEST(Partition, AShapeAcrossTheCornerHasItsCenterInOneTileAndOffsetsInTheOthers) {
  // Shape 0 covers x 7, 8, 9 and y 7, 8, 9 of the plane: center (8, 8), the texels at x = 0 lie one tile to the right.
  const auto partition = blocks();
  EXPECT_EQ(partition.centers[0], V2i(8, 8));
  EXPECT_EQ(partition.owner(8, 8), (OwnerOffset{0, 0}));
  EXPECT_EQ(partition.owner(0, 8), (OwnerOffset{-1, 0}));
  EXPECT_EQ(partition.owner(8, 0), (OwnerOffset{0, -1}));
  EXPECT_EQ(partition.owner(0, 0), (OwnerOffset{-1, -1}));
  EXPECT_EQ(partition.unwrapped(0, 0), V2i(9, 9));
}

TEST(Partition, AShapeThatLeansOverTheBorderBelongsToTheTileOfItsCenter) {
  // Shape 3 covers x 7, 8, 9: most of it is right of the border only when shifted; here the center is x = 8.
  EXPECT_EQ(blocks().centers[3], V2i(8, 2));
  // Shifted by one texel to the right the center crosses the border, and the texels left of it point forward.
  auto ids = blocks().idx.clone();
  Image<uint32_t> moved(9, 9);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) moved(wrap(x + 1, 9), y) = ids(x, y);
  const auto partition = unwrap(std::move(moved));
  EXPECT_EQ(partition.centers[3], V2i(0, 2));
  EXPECT_EQ(partition.owner(8, 2), (OwnerOffset{1, 0}));
  EXPECT_EQ(partition.owner(1, 2), (OwnerOffset{0, 0}));
}

TEST(Partition, CentersRoundHalfUpOnBothSidesOfZero) {
  EXPECT_EQ(rounded_mean(1, 2), 1);
  EXPECT_EQ(rounded_mean(-1, 2), 0);
  EXPECT_EQ(rounded_mean(-3, 2), -1);
  EXPECT_EQ(rounded_mean(-2, 3), -1);
  EXPECT_EQ(rounded_mean(-1, 3), 0);
  EXPECT_EQ(rounded_mean(7, 3), 2);
  EXPECT_EQ(rounded_mean(0, 5), 0);
}

TEST(Partition, RandomBlocksKeepTheLawsWhereverTheTorusIsCut) {
  const auto ids = blocks().idx.clone();
  for (int dy = 0; dy < 9; ++dy)
    for (int dx = 0; dx < 9; ++dx) {
      Image<uint32_t> moved(9, 9);
      for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) moved(wrap(x + dx, 9), wrap(y + dy, 9)) = ids(x, y);
      const auto partition = unwrap(std::move(moved));
      expect_whole(partition);
      EXPECT_TRUE(check_partition(partition).empty());
      for (size_t shape = 0; shape < 9; ++shape)
        EXPECT_EQ(partition.centers[shape],
                  wrap(V2i(blocks().centers[shape].x + dx, blocks().centers[shape].y + dy), V2i(9, 9)));
    }
}

TEST(Partition, ARingAroundTheTorusDoesNotUnwrap) {
  EXPECT_THAT(unwrap_error("00000000 11122233 11122233 11122233 44455566 44455566 44455566 77788899"),
              HasSubstr("shape 0"));
}

TEST(Partition, AShapeOfHalfTheTileIsRefusedAndOneTexelLessIsNot) {
  const std::string wide = "00001122 00001122 33334455 33334455 66667788 66667788 9999aabb 9999aabb";
  EXPECT_THAT(unwrap_error(wide), HasSubstr("at most 3 x 3"));
  EXPECT_EQ(unwrap_error("00011122 00011122 33344455 33344455 66677788 66677788 999aaabb 999aaabb"), "");
}

TEST(Partition, TwoPiecesOfOneShapeAreRefusedWithTheSecond) {
  EXPECT_THAT(unwrap_error("00112233 00112233 44556677 44550077 8899aabb 8899aabb ccddeeff ccddeeff"),
              HasSubstr("shape 0 to be 4-connected"));
}

TEST(Partition, TouchingAtACornerIsNotConnected) {
  EXPECT_THAT(unwrap_error("01223344 10223344 55667788 55667788 99aabbcc 99aabbcc ddeeffgg ddeeffgg"),
              HasSubstr("4-connected"));
}

TEST(Partition, AMissingShapeIsRefused) {
  EXPECT_THAT(unwrap_error("00112233 00112233 44556677 44556677 8899aabb 8899aabb ccddeegg ccddeegg"),
              HasSubstr("no texel of shape 15"));
}

TEST(CheckPartition, AWholePartitionHasNoFault) { EXPECT_TRUE(check_partition(blocks()).empty()); }

std::vector<PartitionFault::Kind> kinds(const std::vector<PartitionFault>& faults) {
  std::vector<PartitionFault::Kind> result;
  for (const auto& fault : faults) result.push_back(fault.kind);
  return result;
}
using Kind = PartitionFault::Kind;

TEST(CheckPartition, AnIdxOutOfRangeIsFoundOnceWithItsCountAndFirstTexel) {
  auto partition = blocks();
  partition.idx(4, 4) = 9;
  partition.idx(5, 6) = 4000000000u;
  const auto faults = check_partition(partition);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults[0].kind, Kind::idx_out_of_range);
  EXPECT_EQ(faults[0].texel, V2i(4, 4));
  EXPECT_EQ(faults[0].count, 2u);
}

TEST(CheckPartition, AnEmptyShapeIsFound) {
  auto partition = blocks();
  partition.centers.push_back(V2i(0, 0));
  partition.areas_px.push_back(0);
  EXPECT_THAT(kinds(check_partition(partition)), testing::ElementsAre(Kind::empty_shape));
}

TEST(CheckPartition, AStrayTexelIsFoundAsAPiece) {
  auto partition = blocks();
  partition.idx(2, 2) = 8;  // the middle of shape 4, far from shape 8
  const auto faults = check_partition(partition);
  const auto found = std::find_if(faults.begin(), faults.end(), [](auto& f) { return f.kind == Kind::not_connected; });
  ASSERT_NE(found, faults.end());
  EXPECT_EQ(found->shape, 8u);
  EXPECT_EQ(found->count, 9u) << "the piece that holds the first texel in row order is the shape, the other is stray";
}

TEST(CheckPartition, EachEditedOwnerOffsetIsFound) {
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) {
      auto partition = blocks();
      partition.owner(x, y).x = static_cast<int8_t>(partition.owner(x, y).x + 1);
      EXPECT_THAT(kinds(check_partition(partition)), testing::Contains(Kind::inconsistent_owner)) << x << ", " << y;
    }
}

TEST(CheckPartition, AnOffsetBeyondOneTileIsFoundEvenWhereNeighborsAgree) {
  auto partition = blocks();
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x)
      if (partition.idx(x, y) == 4) partition.owner(x, y) = {2, 0};
  EXPECT_THAT(kinds(check_partition(partition)), testing::ElementsAre(Kind::inconsistent_owner, Kind::wrong_center));
}

TEST(CheckPartition, AMovedCenterAndAWrongAreaAreFound) {
  auto partition = blocks();
  partition.centers[3].x -= 1;
  partition.areas_px[5] += 1;
  EXPECT_THAT(kinds(check_partition(partition)), testing::ElementsAre(Kind::wrong_center, Kind::wrong_area));
}

TEST(CheckPartition, AShapeOfHalfTheTileIsFound) {
  auto partition = blocks();
  for (int x = 4; x < 7; ++x)
    for (int y = 1; y < 4; ++y) partition.idx(x, y) = 4;  // shapes 4 and 5 made one: 6 of 9 texels wide
  EXPECT_THAT(kinds(check_partition(partition)), testing::IsSupersetOf({Kind::too_large, Kind::empty_shape}));
}

}  // namespace
}  // namespace texbake
