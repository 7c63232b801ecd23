#include "libbake/tile/seam_cut.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "libbake/base/random.h"

namespace texbake {
namespace {

Image<float> mismatch_from(const std::vector<std::vector<int>>& rows) {
  Image<float> image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) image(x, y) = static_cast<float>(rows[y][x]);
  return image;
}

// Tries every cut there is.
double least_cost_slowly(ImageView<const float> mismatch, CutEnds ends) {
  std::vector<int> column(static_cast<size_t>(mismatch.height()), 1);
  double least = cut_cost(mismatch, column, ends);
  for (;;) {
    size_t row = 0;
    while (row < column.size() && ++column[row] == mismatch.width()) column[row++] = 1;
    if (row == column.size()) return least;
    least = std::min(least, cut_cost(mismatch, column, ends));
  }
}

TEST(SeamCut, FollowsTheValleyWithoutLeavingIt) {
  // two columns of zeros let a cut pass between them for nothing; they step aside by one in row 1
  const Image<float> mismatch = mismatch_from({{9, 0, 0, 9, 9}, {9, 9, 0, 0, 9}, {9, 9, 0, 0, 9}, {9, 9, 0, 0, 9}});
  const SeamCut cut = minimum_cut(mismatch, CutEnds::open);
  EXPECT_EQ(cut.cost, 0);
  EXPECT_EQ(cut.column, (std::vector<int>{2, 3, 3, 3}));
}

TEST(SeamCut, ClosedCutComesBackToItsStart) {
  // the open valley drifts by two columns; to return costs the pairs it moves over
  const Image<float> mismatch = mismatch_from({{0, 0, 1, 5}, {5, 0, 0, 5}, {5, 1, 0, 0}});
  const SeamCut open = minimum_cut(mismatch, CutEnds::open);
  const SeamCut closed = minimum_cut(mismatch, CutEnds::closed);
  EXPECT_EQ(open.column, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(open.cost, 0);
  // back from column 3 to 1 between rows 2 and 0: (1 + 0) + (0 + 1)
  EXPECT_EQ(closed.cost, 2);
}

TEST(SeamCut, EqualsExhaustiveSearchOnSmallStrips) {
  Random random(7);
  for (int trial = 0; trial < 400; ++trial) {
    const int width = 2 + static_cast<int>(random.below(4)), height = 1 + static_cast<int>(random.below(6));
    Image<float> mismatch(width, height);
    const uint32_t levels = trial % 2 ? 3 : 1000;  // few levels: many ties
    for (float& value : mismatch) value = static_cast<float>(random.below(levels));
    for (const CutEnds ends : {CutEnds::open, CutEnds::closed}) {
      const SeamCut cut = minimum_cut(mismatch, ends);
      ASSERT_EQ(cut.cost, least_cost_slowly(mismatch, ends)) << width << " x " << height << " trial " << trial;
      ASSERT_EQ(cut.cost, cut_cost(mismatch, cut.column, ends));
      ASSERT_TRUE(std::all_of(cut.column.begin(), cut.column.end(), [&](int x) { return x >= 1 && x < width; }));
    }
  }
}

// Every start on its own, every move between two columns tried: no corridors, no sweeps.
double least_closed_cost_by_starts(const Image<float>& mismatch) {
  const int width = mismatch.width(), rows = mismatch.height();
  const auto move = [&](int a, int b, int y) {
    double cost = mismatch(b - 1, (y + 1) % rows) + mismatch(b, (y + 1) % rows);
    for (int x = std::min(a, b); x < std::max(a, b); ++x) cost += mismatch(x, y) + mismatch(x, (y + 1) % rows);
    return cost;
  };
  double least = 1e30;
  for (int start = 1; start < width; ++start) {
    std::vector<double> cost(static_cast<size_t>(width), 1e30);
    cost[start] = 0;
    for (int y = 0; y < rows; ++y) {
      std::vector<double> next(cost.size(), 1e30);
      for (int a = 1; a < width; ++a)
        for (int b = 1; b < width; ++b) next[b] = std::min(next[b], cost[a] + move(a, b, y));
      cost = next;
    }
    least = std::min(least, cost[start]);
  }
  return least;
}

TEST(SeamCut, ClosedCutsOfWideStripsAreTheCheapestOfAllStarts) {
  Random random(8);
  for (int trial = 0; trial < 10; ++trial) {
    Image<float> mismatch(20, 30);
    for (float& value : mismatch) value = static_cast<float>(random.below(trial % 2 ? 4 : 50));
    const SeamCut cut = minimum_cut(mismatch, CutEnds::closed);
    EXPECT_EQ(cut.cost, least_closed_cost_by_starts(mismatch));
    EXPECT_EQ(cut.cost, cut_cost(mismatch, cut.column, CutEnds::closed));
  }
}

}  // namespace
}  // namespace texbake
