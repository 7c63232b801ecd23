#include "libbake/noise/noise_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace texbake {
namespace {

constexpr int kSides[] = {512, 1024, 2048, 4096};

uint32_t index_at(const NoiseLattice& lattice, int x, int y) {
  return lattice.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y));
}

/// Where on row y, −count/2 … count/2 − 1, the lattice shows the value `index`.
int column_of(const NoiseLattice& lattice, uint32_t index, int y) {
  return shortest(static_cast<int>((index - index_at(lattice, 0, y)) & static_cast<uint32_t>(lattice.count - 1)),
                  lattice.count);
}

/// How far from texel (x, y) the value that shows at (0, 0) shows too; `limit` where it does not within that.
double nearest_return(const NoiseLattice& lattice, int x, int y, int limit) {
  const auto back = static_cast<uint32_t>(lattice.count) - index_at(lattice, x, y);
  double least = limit;
  for (int dy = -limit; dy <= limit; ++dy) {
    const int dx = column_of(lattice, back, dy);
    least = std::min(least, std::hypot(dx, dy));
  }
  return least;
}

TEST(NoiseLattice, IsSeamlessEverywhere) {
  for (const int side : kSides) {
    const NoiseLattice lattice = noise_lattice(side);
    EXPECT_EQ(lattice.count, side * side);
    EXPECT_EQ(lattice.row_step % 2, 1);
    const auto next = [&](uint32_t index, int by) {
      return (index + static_cast<uint32_t>(by)) & static_cast<uint32_t>(lattice.count - 1);
    };
    // Neighbors are neighbors across 2^32, where coordinates wrap, as everywhere.
    for (const uint32_t x : {0u, 17u, 0x7fffffffu, 0xffffffffu})
      for (const uint32_t y : {0u, 5u, 0x7fffffffu, 0xffffffffu}) {
        EXPECT_EQ(lattice.index(x + 1, y), next(lattice.index(x, y), 1));
        EXPECT_EQ(lattice.index(x, y + 1), next(lattice.index(x, y), lattice.row_step));
      }
    EXPECT_EQ(lattice.index(0, 0), 0u);
    EXPECT_EQ(lattice.index(7, 2), static_cast<uint32_t>(7 + 2 * lattice.row_step) % (side * side));
  }
}

TEST(NoiseLattice, ShowsEveryValueOnceInARowAndInAColumn) {
  const NoiseLattice lattice{64, 23};
  std::vector<int> in_row(64), in_column(64);
  for (uint32_t i = 0; i < 64; ++i) {
    ++in_row[lattice.index(i, 3)];
    ++in_column[lattice.index(3, i)];
  }
  EXPECT_EQ(in_row, std::vector<int>(64, 1));
  EXPECT_EQ(in_column, std::vector<int>(64, 1));
}

TEST(NoiseLattice, ValuesReturnFarAwayAndFarFromTheAxes) {
  for (const int side : kSides) {
    const NoiseLattice lattice = noise_lattice(side);
    double shortest_way = lattice.count;
    double least_product = lattice.count;
    for (int y = 1; y <= 2 * side; ++y) {
      const double x = std::abs(column_of(lattice, 0, y));
      shortest_way = std::min(shortest_way, std::hypot(x, y));
      if (x > 0) least_product = std::min(least_product, x * y);
    }
    EXPECT_GE(shortest_way, 0.98 * side);
    EXPECT_GE(least_product, double{0.2} * side * side);
  }
}

TEST(NoiseLattice, TilesDoNotShowTheSameNoiseInRepetitionsNear) {
  for (const int side : kSides)
    for (const int tile : {512, 1024, 2048, 4096}) {
      const NoiseLattice lattice = noise_lattice(side);
      const int most = tile <= side ? 6 : tile == 2 * side ? 3 : 1;
      for (int j = 0; j <= most; ++j)
        for (int i = -most; i <= most; ++i) {
          if (i == 0 && j == 0) continue;
          EXPECT_GE(nearest_return(lattice, i * tile, j * tile, 64), 49)
              << side << ", tiles of " << tile << ", repetition " << i << ", " << j;
        }
    }
}

TEST(NoiseLattice, AFrequencyCountsTheSameAlongTheValuesAndOnThePlane) {
  const NoiseLattice lattice{256, 161};
  for (const int k : {0, 1, 2, 77, 128, 200, 255}) {
    const Imath::V2d f = lattice.frequency(k);
    EXPECT_LE(std::max(std::abs(f.x), std::abs(f.y)), 0.5);
    for (const V2i& p : {V2i(1, 0), V2i(0, 1), V2i(13, 250), V2i(1000, 77)}) {
      const double along = double{1} * k * index_at(lattice, p.x, p.y) / 256;
      const double on_plane = f.x * p.x + f.y * p.y;
      EXPECT_NEAR(std::remainder(along - on_plane, 1.0), 0.0, 1e-9) << k;
    }
  }
}

}  // namespace
}  // namespace texbake
