#include "libbake/content/cell_grid.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(CellGrid, TheFirstAndTheMiddleTexelOfACellLieInIt) {
  const CellGrid grid{{100, 67}, {91, 64}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 91; ++x) {
      EXPECT_EQ(grid.cell_of(grid.first_px({x, y})), V2i(x, y));
      EXPECT_EQ(grid.cell_of(grid.middle_px({x, y})), V2i(x, y));
    }
  EXPECT_EQ(grid.first_px({91, 64}), V2i(100, 67));
}

TEST(CellGrid, CellsOfEqualSizeHaveTheirMiddleHalfway) {
  const CellGrid grid{{256, 512}, {64, 64}};
  EXPECT_EQ(grid.middle_px({0, 63}), V2i(2, 508));
  EXPECT_EQ(grid.cell_of({255, 7}), V2i(63, 0));
}

}  // namespace
}  // namespace texbake
