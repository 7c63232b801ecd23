#include "libbake/draw/stack_perspective.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/draw/stack_window.h"
#include "libbake/draw/view_program.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/stack_levels.h"
#include "small_stack.h"

namespace texbake {
namespace {

StackPlanes leveled(const SmallStack& stack) {
  StackPlanes planes = stack.planes();
  return planes;
}

Perspective view_of(int width, int height) {
  Perspective view;
  view.width = width;
  view.height = height;
  view.seed = 3;
  return view;
}

glsl::StackSight sight(const StackPlanes& planes, const Perspective& view, float x, float y) {
  glsl::PerspectiveProgram program =
      with_view(program_of(planes, view.seed, {view.origin_x.tile, view.origin_y.tile}), view);
  return program.stack_sight_at(point_below(view), x, y);
}

TEST(StackPerspective, AStackOfOneScaleIsThatScale) {
  SmallStack stack;
  stack.add(random_scale({64, 32}, 5, Contents::turned, 6));
  EvaluatorPlanes alone = prepare(stack.tiles.front().input());
  const StackPlanes planes = leveled(stack);
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic}) {
    Perspective view = view_of(80, 60);
    view.filter = filter;
    view.height_texels = 200;
    view.yaw_deg = 33;
    EXPECT_TRUE(render_stack_perspective_rows(planes, nullptr, view, 0, 60) ==
                render_perspective_rows(alone, alone.base, view, 0, 60))
        << enum_name(filter);
  }
}

TEST(StackPerspective, LookingStraightDownShowsTheWindow) {
  const StackPlanes planes = leveled(two_scales({.ratio = 4}));
  for (const int texels : {1, 2, 4, 8}) {  // to a pixel: alone, fading, the coarser scale, its levels
    Perspective view = view_of(64, 64);
    view.pitch_deg = 90;
    view.fov_deg = 90;
    view.height_texels = 32 * texels;  // tan 45° · 32 pixels
    view.filter = Filter::trilinear;
    Window window;
    window.origin_x = tile_offset(-32 * texels, 0, 16);
    window.origin_y = tile_offset(-32 * texels, 0, 32);
    window.width = window.height = 64;
    window.step_256 = static_cast<uint32_t>(256 * texels);
    window.seed = 3;
    window.filter = Filter::trilinear;
    const Image<V3f> found = render_stack_perspective_rows(planes, nullptr, view, 0, 64);
    const Image<V3f> expected = render_stack_rows(planes, window, 0, 64);
    double worst = 0, mean = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      const double d = (found.data()[i] - expected.data()[i]).length();
      worst = std::max(worst, d);
      mean += d / static_cast<double>(found.size());
    }
    // White noise of 0 … 4, coarse and fine: rays end in 1/256 texel, levels and fading in as much.
    EXPECT_LT(worst, 0.5) << texels;
    EXPECT_LT(mean, 0.05) << texels;
  }
}

TEST(StackPerspective, TheScaleThatShowsGoesFromFineToCoarseWithDistance) {
  SmallStack stack = two_scales({.ratio = 4});
  stack.add(random_scale({16, 16}, 3, Contents::moved, 9), {.ratio = 8});
  const StackPlanes planes = leveled(stack);
  Perspective view = view_of(100, 200);
  view.height_texels = 60;
  view.pitch_deg = 25;
  int scale = 3;
  double coarseness = 0;
  for (int y = 199; y >= 0; --y) {
    const glsl::StackSight seen = sight(planes, view, 50.5f, static_cast<float>(y) + 0.5f);
    if (!seen.hits) break;
    EXPECT_LE(seen.seen.scale, scale);
    scale = seen.seen.scale;
    // How far from the finest scale, in levels of it: grows without a jump.
    const double passed = scale == 2 ? 0 : scale == 1 ? 3 : 5;
    const double here = passed + seen.seen.row.level_256 / 256.0;
    EXPECT_GE(here, coarseness - 0.02);
    coarseness = here;
  }
  EXPECT_EQ(scale, 0);
}

TEST(StackPerspective, TheSamePlaceIsSeenInEveryScale) {
  const StackPlanes planes = leveled(two_scales({.ratio = 4}));
  Perspective view = view_of(100, 100);
  view.pitch_deg = 40;
  view.height_texels = 3000;
  view.origin_x = tile_offset(-5000000001, 17, 16);
  view.origin_y = tile_offset(123456789012, 99, 32);
  glsl::PerspectiveProgram program =
      with_view(program_of(planes, view.seed, {view.origin_x.tile, view.origin_y.tile}), view);
  for (int i = 0; i < 100; ++i) {
    const auto ground = program.ground_at(static_cast<float>(i), static_cast<float>(99 - i / 2));
    const glsl::Position fine = program.stack_position(point_below(view), ground.to, 1);
    program.use_scale(1);
    const glsl::Position expected = program.coarser_position(1, fine);
    const glsl::Position found = program.stack_position(point_below(view), ground.to, 0);
    EXPECT_EQ(found.tile.x, expected.tile.x);
    EXPECT_NEAR(found.offset.x, expected.offset.x, 2);  // 1/256 texel, rounded twice
    EXPECT_NEAR(found.offset.y, expected.offset.y, 2);
  }
}

TEST(StackPerspective, FilteredViewsApproachTheSupersampledTruth) {
  const StackPlanes planes = leveled(two_scales({.ratio = 8}, Contents::moved, 20));
  Perspective view = view_of(48, 32);
  view.pitch_deg = 25;
  view.height_texels = 100;
  const Image<V3f> truth = supersampled_stack_perspective_rows(planes, nullptr, view, 16, 0, 32);
  const auto error = [&](Filter filter) {
    view.filter = filter;
    const Image<V3f> found = render_stack_perspective_rows(planes, nullptr, view, 0, 32);
    double sum = 0;
    for (size_t i = 0; i < found.size(); ++i) sum += (found.data()[i] - truth.data()[i]).length();
    return sum / static_cast<double>(found.size());
  };
  const double bilinear = error(Filter::bilinear), anisotropic = error(Filter::anisotropic);
  EXPECT_LT(anisotropic, 0.3 * bilinear) << "white noise, 0 … 4, of both scales";
}

TEST(StackPerspective, CutsIntoRowsDoNotShow) {
  const StackPlanes planes = leveled(two_scales({.ratio = 4}));
  const Perspective view = view_of(40, 30);
  const Image<V3f> whole = render_stack_perspective_rows(planes, nullptr, view, 0, 30);
  const Image<V3f> part = render_stack_perspective_rows(planes, nullptr, view, 11, 19);
  for (int y = 11; y < 19; ++y)
    for (int x = 0; x < 40; ++x) EXPECT_EQ(whole(x, y), part(x, y - 11));
}

}  // namespace
}  // namespace texbake
