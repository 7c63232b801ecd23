#include "libbake/draw/window_part.h"

#include <gtest/gtest.h>

#include "libbake/draw/window_rows.h"
#include "small_tile.h"

namespace texbake {
namespace {

Window far_window(Filter filter) {
  Window window;
  window.origin_x = {0xffffffffu, 31 * 256 + 255};  // the next texel lies in repetition 0
  window.origin_y = {0x7fffffffu, 3};
  window.step_256 = 333;
  window.width = 70;
  window.height = 45;
  window.seed = 7;
  window.filter = filter;
  return window;
}

TEST(WindowPart, PartsShowThePixelsOfTheWhole) {
  const SmallTile tile = random_tile({32, 48}, 5, Contents::turned, 3);
  const EvaluatorPlanes planes = tile.planes();
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    const Window window = far_window(filter);
    const Image<V3f> whole = render_rows(planes, window, 0, window.height);
    const Window part = part_of(window, planes.size, {29, 17}, {30, 20});
    const Image<V3f> drawn = render_rows(planes, part, 0, part.height);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 30; ++x) ASSERT_EQ(drawn(x, y), whole(29 + x, 17 + y)) << x << ", " << y;
  }
}

TEST(WindowPart, ThePointOfAPixelLiesHalfAStepIntoIt) {
  Window window;
  window.step_256 = 256;
  window.origin_x = {0xffffffffu, 0};
  const WindowPoint point = point_of(window, {16, 16}, {16, 2});
  EXPECT_EQ(point.x, (TileOffset{0, 128})) << "one tile on, past the wrap";
  EXPECT_EQ(point.y, (TileOffset{0, 2 * 256 + 128}));
}

}  // namespace
}  // namespace texbake
