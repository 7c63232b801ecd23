#include "libbake/segment/torus_box.h"

#include <gtest/gtest.h>

#include "libbake/base/random.h"

namespace texbake {
namespace {

TorusBox box(int x, int y, int width, int height) { return {V2i(x, y), V2i(width, height)}; }

TEST(TorusBox, TheFirstTexelIsTheBox) { EXPECT_EQ(joined(TorusBox{}, V2i(7, 3), V2i(8, 8)), box(7, 3, 1, 1)); }

TEST(TorusBox, GrowsTheShorterWayAcrossTheBorder) {
  const V2i size(10, 8);
  EXPECT_EQ(joined(box(8, 6, 2, 2), V2i(0, 7), size), box(8, 6, 3, 2));
  EXPECT_EQ(joined(box(0, 0, 2, 2), V2i(9, 7), size), box(9, 7, 3, 3));
  EXPECT_EQ(joined(box(8, 6, 4, 4), V2i(1, 1), size), box(8, 6, 4, 4));
}

TEST(TorusBox, JoinsBoxesThatTouchOrOverlap) {
  const V2i size(20, 20);
  EXPECT_EQ(joined(box(18, 2, 4, 3), box(2, 4, 3, 2), size), box(18, 2, 7, 4));
  EXPECT_EQ(joined(box(2, 4, 3, 2), box(18, 2, 4, 3), size), box(18, 2, 7, 4));
  EXPECT_EQ(joined(box(5, 5, 6, 6), box(7, 7, 2, 2), size), box(5, 5, 6, 6));
  EXPECT_EQ(joined(box(7, 7, 2, 2), box(5, 5, 6, 6), size), box(5, 5, 6, 6));
}

TEST(TorusBox, AWalkOfUnderHalfTheTileHasItsPlaneBox) {
  Random random(3);
  for (int walk = 0; walk < 200; ++walk) {
    const V2i size(21, 17);
    V2i p(static_cast<int>(random.below(21)), static_cast<int>(random.below(17))), low = p, high = p;
    TorusBox found = joined(TorusBox{}, p, size);
    for (int step = 0; step < 40; ++step) {
      const uint32_t n = random.below(4);
      const V2i q(p.x + kNeighborX[n], p.y + kNeighborY[n]);
      const V2i new_low(std::min(low.x, q.x), std::min(low.y, q.y)),
          new_high(std::max(high.x, q.x), std::max(high.y, q.y));
      if (2 * (new_high.x - new_low.x + 1) >= size.x || 2 * (new_high.y - new_low.y + 1) >= size.y) continue;
      p = q;
      low = new_low;
      high = new_high;
      found = joined(found, wrap(p, size), size);
    }
    EXPECT_EQ(found.low, wrap(low, size));
    EXPECT_EQ(found.extent, V2i(high.x - low.x + 1, high.y - low.y + 1));
  }
}

}  // namespace
}  // namespace texbake
