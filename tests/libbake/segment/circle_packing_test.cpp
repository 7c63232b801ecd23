#include "libbake/segment/circle_packing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbake {
namespace {

double nearest_other(const CirclePacking& packing, size_t i) {
  double nearest = 1e30;
  for (size_t j = 0; j < packing.centers.size(); ++j)
    if (j != i) nearest = std::min(nearest, packing.squared_distance(packing.centers[j], i));
  return std::sqrt(nearest);
}

TEST(CirclePacking, CirclesOfHalfACellDoNotOverlapMuchAndLeaveNoHoles) {
  for (uint32_t seed = 1; seed <= 20; ++seed) {
    const auto packing = pack_circles(V2i(1024, 1024), 16, seed);
    for (size_t i = 0; i < 16; ++i) {
      EXPECT_GT(nearest_other(packing, i), 0.6) << "seed " << seed;  // 1.07 in the densest packing
      EXPECT_LT(nearest_other(packing, i), 1.3) << "seed " << seed;
    }
    for (double y = 0; y < 1024; y += 32)
      for (double x = 0; x < 1024; x += 32) {
        double nearest = 1e30;
        for (size_t i = 0; i < 16; ++i) nearest = std::min(nearest, packing.squared_distance(V2d(x, y), i));
        EXPECT_LT(std::sqrt(nearest), 1.1) << "seed " << seed;  // 0.62 in the densest packing
      }
  }
}

TEST(CirclePacking, TheFirstLiesOverTheCornerOfTheTile) {
  EXPECT_EQ(pack_circles(V2i(300, 200), 12, 5).centers[0], V2d(0, 0));
}

TEST(CirclePacking, CentersLieInTheTile) {
  for (const V2d& c : pack_circles(V2i(300, 200), 64, 5).centers) {
    EXPECT_TRUE(c.x >= 0 && c.x < 300 && c.y >= 0 && c.y < 200) << c.x << ", " << c.y;
  }
}

TEST(CirclePacking, ACellIsSquareWhereItCanAndStaysUnderHalfOfALongTile) {
  EXPECT_DOUBLE_EQ(packing_cell(V2i(1024, 1024), 16).x, 256);
  EXPECT_DOUBLE_EQ(packing_cell(V2i(1024, 1024), 16).y, 256);
  EXPECT_NEAR(packing_cell(V2i(1024, 512), 32).x, 128, 1e-9);
  const V2d narrow = packing_cell(V2i(64, 1024), 16);
  EXPECT_NEAR(narrow.x, 64.0 / 3, 1e-9);
  EXPECT_NEAR(narrow.x * narrow.y, 64 * 1024 / 16.0, 1e-6);
}

TEST(CirclePacking, DistancesAreTheShortestOnTheTorus) {
  CirclePacking packing{V2i(100, 60), V2d(10, 20), {V2d(1, 1)}, {0}};
  EXPECT_DOUBLE_EQ(packing.squared_distance(V2d(99, 59), 0), 0.04 + 0.01);
  EXPECT_DOUBLE_EQ(packing.squared_distance(V2d(21, 1), 0), 4);
}

TEST(CirclePacking, SeedsAndStreamsGiveOtherPackings) {
  const auto centers = [](uint32_t seed, uint32_t stream) {
    return pack_circles(V2i(256, 256), 16, seed, stream).centers;
  };
  EXPECT_EQ(centers(1, 0), centers(1, 0));
  EXPECT_NE(centers(1, 0), centers(2, 0));
  EXPECT_NE(centers(1, 0), centers(1, 1));
}

TEST(Balance, SharesThePointsEvenlyByWeight) {
  std::vector<V2d> points;
  std::vector<uint32_t> weights;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      points.push_back({4 * x + 2.0, 4 * y + 2.0});
      weights.push_back(x < 32 ? 1 : 3);
    }
  const auto packing = balance(pack_circles(V2i(256, 256), 16, 3), points, weights);
  std::vector<double> taken(16, 0);
  for (size_t p = 0; p < points.size(); ++p) {
    size_t best = 0;
    const auto distance = [&](size_t i) { return packing.squared_distance(points[p], i) - packing.power[i]; };
    for (size_t i = 1; i < 16; ++i)
      if (distance(i) < distance(best)) best = i;
    taken[best] += weights[p];
  }
  for (const double share : taken) EXPECT_NEAR(share, 512, 0.05 * 512);  // one point is 0.6 % of a share
}

}  // namespace
}  // namespace texbake
