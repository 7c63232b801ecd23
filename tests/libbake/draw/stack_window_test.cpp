#include "libbake/draw/stack_window.h"

#include <gtest/gtest.h>

#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "small_stack.h"

namespace texbake {
namespace {

Window window_at(int64_t x, int64_t y, V2i tile, uint32_t step_256, int side = 24) {
  Window window;
  window.origin_x = tile_offset(x, 0, tile.x);
  window.origin_y = tile_offset(y, 0, tile.y);
  window.step_256 = step_256;
  window.width = window.height = side;
  window.seed = 11;
  return window;
}

TEST(StackWindow, AStackOfOneScaleIsThatScale) {
  SmallStack stack;
  stack.add(random_scale({32, 16}, 3, Contents::turned, 6));
  const StackPlanes planes = stack.planes();
  const EvaluatorPlanes alone = prepare(stack.tiles.front().input());
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    Window window = window_at(-100, 33, {32, 16}, 200);
    window.filter = filter;
    EXPECT_TRUE(render_stack_rows(planes, window, 0, 24) == render_rows(alone, window, 0, 24));
  }
}

TEST(StackWindow, NearTheFinestScaleShowsAloneAndFarTheCoarsest) {
  const StackPlanes planes = two_scales({.ratio = 8, .variation_fade = 2}).planes();
  const auto view = [&](double texels) { return scale_view(planes, texels); };
  EXPECT_EQ(view(0.5).scale, 1);
  EXPECT_EQ(view(1).fading, 0);
  EXPECT_EQ(view(1).variation, 1);
  EXPECT_NEAR(view(2).fading, 1.0 / 3, 1e-6);
  EXPECT_NEAR(view(2).variation, 1.0 / 3, 1e-6);
  EXPECT_EQ(view(4).variation, 0);  // gone before the dominant color
  EXPECT_LT(view(4).fading, 1);
  EXPECT_EQ(view(8).scale, 0);
  EXPECT_EQ(view(8).fading, 0);
  EXPECT_EQ(view(1000).scale, 0);
}

TEST(StackWindow, FromAfarAStackIsItsCoarsestScale) {
  const SmallStack stack = two_scales({.ratio = 4});
  const StackPlanes planes = stack.planes();
  const EvaluatorPlanes coarse = prepare(stack.tiles.front().input());
  Window far = window_at(-64, 128, planes.sizes[1], 4 * 256);
  far.filter = Filter::nearest;
  Window same = window_at(-16, 32, {32, 16}, 256);
  same.filter = Filter::nearest;
  // Scales draw by seeds of their own; the finest has the window's.
  same.seed = far.seed + 2654435769u;
  EXPECT_TRUE(render_stack_rows(planes, far, 0, 24) == render_rows(coarse, same, 0, 24));
}

TEST(StackWindow, AWindowIsTheSumOfItsRows) {
  const StackPlanes planes = two_scales({.ratio = 4}).planes();
  const Window window = window_at(-1000, 77, planes.sizes[1], 500);
  const Image<V3f> whole = render_stack_rows(planes, window, 0, 24), part = render_stack_rows(planes, window, 9, 14);
  for (int y = 9; y < 14; ++y)
    for (int x = 0; x < 24; ++x) EXPECT_EQ(whole(x, y), part(x, y - 9));
}

TEST(StackWindow, FadedWhollyIsTheCoarserScaleAtTheSamePoint) {
  const StackPlanes planes = two_scales({.ratio = 4}).planes();
  const Window window = window_at(-40, 24, planes.sizes[1], 256);
  const Image<V3f> faded = render_scale_rows(planes, window, {1, 1, 0}, 0, 24);
  const Image<V3f> expected = render_scale_rows(planes, window, {0, 0, 1}, 0, 24);
  EXPECT_TRUE(faded == expected);
}

TEST(StackWindow, TheSamePointIsFoundFarFromTheOrigin) {
  const StackPlanes planes = two_scales({.ratio = 4}).planes();
  const Window window = window_at(-23456789012, 59999999999, planes.sizes[1], 4 * 256);
  glsl::Program program = window_program_of(planes, window);
  const glsl::Position at = stack_pixel_position(program, window, 0, 3, 5);
  // Pixels are as large as coarse texels: centers half a texel further, and 3/4 of one by the origin's rest.
  const TileOffset x = tile_offset(-23456789012 / 4 + 3, 128, planes.sizes[0].x);
  const TileOffset y = tile_offset(59999999999 / 4 + 5, 128 + 192, planes.sizes[0].y);
  EXPECT_EQ(TileOffset(at.tile.x, static_cast<uint32_t>(at.offset.x)), x);
  EXPECT_EQ(TileOffset(at.tile.y, static_cast<uint32_t>(at.offset.y)), y);
}

}  // namespace
}  // namespace texbake
