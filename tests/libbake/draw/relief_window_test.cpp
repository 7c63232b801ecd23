#include "libbake/draw/relief_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/stack_levels.h"
#include "small_stack.h"

namespace texbake {
namespace {

constexpr Direction kAslant{0.5f, -0.3f, 0.8f}, kLight{-1, -1, 1.4f};

/// A scale with a height map, and a normal map where one is given.
struct HighTile {
  ScaleTile scale;
  Image<float> height;
  Image<float> normal[3];

  EvaluatorInput input() const {
    EvaluatorInput input = scale.input();
    input.maps.push_back({"height", MapKind::height, {height}});
    if (!normal[0].empty()) input.maps.push_back({"normal", MapKind::normal_opengl, {normal[0], normal[1], normal[2]}});
    return input;
  }
  StackPlanes stack() const {
    const std::vector<StackScale> scales = {{input(), nullptr}};
    StackPlanes stack = prepare_stack(scales);
    return stack;
  }
  ReliefPlanes relief(const ReliefOptions& options, const Direction& light = kLight) const {
    return relief_planes(input(), options, light);
  }
};

/// The text with the relief bound, asked for rays by themselves: pixels too small for levels of detail.
struct Rays {
  StackPlanes stack;
  ReliefPlanes relief;
  glsl::Program program = program_of(stack, 0, {0, 0});

  Rays(const HighTile& tile, const ReliefOptions& options, const Direction& light = kLight)
      : stack(tile.stack()), relief(tile.relief(options, light)) {
    bind_relief(program, relief);
  }
  /// What the ray to `viewer` through a texel of the tile, and a part of one, meets.
  glsl::Program::Relieved met(double x, double y, const Direction& viewer) {
    const glsl::Position at{{5, 5}, {static_cast<int>(x * 256), static_cast<int>(y * 256)}};
    return program.relief_at({at, {0, 0}, 0, 0}, {-viewer.x / viewer.z, -viewer.y / viewer.z}, 0.01f);
  }
  double light_at(double x, double y) { return met(x, y, {0, 0, 1}).light_4096 / 4096.0; }
};

/// Height `of(x, y)`; contents are the identity alone, so that places are those of the tile.
template <class Height>
HighTile tile_of(V2i size, const Height& of) {
  HighTile tile{random_scale(size, 1, Contents::moved, 3), Image<float>(size.x, size.y), {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) tile.height(x, y) = static_cast<float>(of(x, y));
  return tile;
}

Window window_of_side(int side) {
  Window window;
  window.origin_x = tile_offset(-7, 30, 32);
  window.origin_y = tile_offset(5, 0, 32);
  window.step_256 = 100;
  window.width = window.height = side;
  return window;
}

TEST(ReliefWindow, AFlatHeightGivesNoRelief) {
  for (const double height : {0.0, 0.4, 1.0}) {
    const HighTile tile = tile_of({32, 32}, [&](int, int) { return height; });
    const StackPlanes stack = tile.stack();
    const ReliefPlanes relief = tile.relief({.depth_px = 20});
    const Window window = window_of_side(40);
    EXPECT_TRUE(render_relief_rows(stack, relief, kAslant, window, 0, 40) == render_stack_rows(stack, window, 0, 40));
  }
}

TEST(ReliefWindow, SeenFromAboveNothingMoves) {
  const HighTile tile = tile_of({32, 32}, [](int x, int y) { return (x * 7 + y * 3) % 10 / 10.0; });
  const StackPlanes stack = tile.stack();
  const ReliefPlanes relief = tile.relief({.depth_px = 20, .shade_by = ShadeBy::none});
  const Window window = window_of_side(40);
  EXPECT_TRUE(render_relief_rows(stack, relief, {0, 0, 1}, window, 0, 40) == render_stack_rows(stack, window, 0, 40));
}

TEST(ReliefWindow, WhereAPixelIsAsLargeAsTheReliefNothingMoves) {
  const HighTile tile = tile_of({32, 32}, [](int x, int y) { return (x * 7 + y * 3) % 10 / 10.0; });
  const StackPlanes stack = tile.stack();
  const ReliefPlanes relief = tile.relief({.depth_px = 4, .shade_by = ShadeBy::none});
  Window window = window_of_side(40);
  window.filter = Filter::trilinear;
  window.step_256 = 4 * 256;
  EXPECT_TRUE(render_relief_rows(stack, relief, kAslant, window, 0, 40) == render_stack_rows(stack, window, 0, 40));
  window.step_256 = 256;
  EXPECT_FALSE(render_relief_rows(stack, relief, kAslant, window, 0, 40) == render_stack_rows(stack, window, 0, 40));
}

/// Where the ray through (x, y), on the plane of height `plane`, first meets the surface: in steps of 1/2000 of the
/// depth.
double slow_hit(const std::function<double(double, double)>& height, double x, double y, double plane, double slope_x,
                double slope_y) {
  for (double level = 1; level > 0; level -= 1.0 / 2000)
    if (height(x + slope_x * (plane - level), y + slope_y * (plane - level)) >= level) return level;
  return 0;
}

TEST(ReliefWindow, ARayMeetsTheSurfaceWhereASlowWalkDoes) {
  const auto of = [](double x, double y) {
    return 0.5 + 0.3 * std::sin(2 * M_PI * x / 32) + 0.2 * std::cos(2 * M_PI * y / 32);
  };
  const HighTile tile = tile_of({32, 32}, [&](int x, int y) { return of(x + 0.5, y + 0.5); });
  Rays rays(tile, {.depth_px = 8, .linear_steps = 64});
  const double slope_x = -0.5 / 0.8 * 8, slope_y = 0.3 / 0.8 * 8;
  for (int i = 0; i < 300; ++i) {
    const double x = i * 37 % 32 + 0.25, y = i * 11 % 32 + 0.75;
    const double level = slow_hit(of, x, y, double{rays.relief.relief_range.z}, slope_x, slope_y);
    // A bilinear surface is off the smooth one by h''/8 = 0.0015, a ray of slope 6 by 0.01 texels; it may graze.
    EXPECT_NEAR(double{rays.met(x, y, kAslant).moved.x}, slope_x * (double{rays.relief.relief_range.z} - level), 0.1)
        << x << " " << y;
  }
}

TEST(ReliefWindow, WhatRisesTowardsTheViewerHidesWhatIsBehind) {
  // A wall of height 1 at x = 16 … 17 on a floor of height 0; seen from the left, its far side is hidden.
  const HighTile tile = tile_of({32, 32}, [](int x, int) { return x == 16 ? 1 : 0; });
  Rays rays(tile, {.depth_px = 4, .linear_steps = 64});
  for (double x = 0; x < 32; x += 0.15625) {
    const double met = x + double{rays.met(x, 16, {-1, 0, 1}).moved.x};
    EXPECT_FALSE(met > 18 && met < 19) << x;
  }
}

TEST(ReliefWindow, SlopesTowardsTheLightAreBright) {
  const HighTile tile = tile_of({32, 32}, [](int x, int) { return 0.5 + 0.5 * std::sin(2 * M_PI * x / 32); });
  Rays rays(tile, {.depth_px = 10, .ambient = 0}, {-1, 0, 1});
  EXPECT_GT(rays.light_at(0.5, 0.5), 1.1);   // rises to the right, faces left
  EXPECT_LT(rays.light_at(16.5, 0.5), 0.7);  // falls to the right
}

TEST(ReliefWindow, ANormalMapOfTheHeightsShadesAsTheHeightsDo) {
  const double depth = 6;
  const auto of = [](double x, double y) {
    return 0.5 + 0.3 * std::sin(2 * M_PI * x / 32) + 0.2 * std::cos(2 * M_PI * y / 32);
  };
  HighTile tile = tile_of({32, 32}, of);
  for (Image<float>& channel : tile.normal) channel = Image<float>(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const double dx = depth * (of(x + 1, y) - of(x - 1, y)) / 2, dy = depth * (of(x, y + 1) - of(x, y - 1)) / 2;
      const double length = std::sqrt(1 + dx * dx + dy * dy);
      tile.normal[0](x, y) = static_cast<float>(-dx / length);
      tile.normal[1](x, y) = static_cast<float>(dy / length);  // +y up
      tile.normal[2](x, y) = static_cast<float>(1 / length);
    }
  Rays by_height(tile, {.depth_px = 6}), by_normal(tile, {.depth_px = 6, .shade_by = ShadeBy::normal});
  // Steps of 1/4096.
  for (int x = 0; x < 32; ++x) EXPECT_NEAR(by_height.light_at(x + 0.5, 7.5), by_normal.light_at(x + 0.5, 7.5), 3e-4);
}

TEST(ReliefWindow, AFrameIsTheWindowWithWhatWasFoundBehindIt) {
  SmallStack stack = two_scales({.ratio = 5}, Contents::turned);
  StackPlanes planes = stack.planes();
  const Image<float> height =
      tile_of({32, 16}, [](int x, int y) { return (x * 7 + y * 3) % 10 / 10.0; }).height.clone();
  EvaluatorInput input = stack.tiles.front().input();
  input.maps.push_back({"height", MapKind::height, {height}});
  const ReliefPlanes relief = relief_planes(input, {.depth_px = 5}, kLight);
  Window window = window_of_side(24);
  window.origin_x = window.origin_y = {3, 700};
  const Image<V3f> rows = render_relief_rows(planes, relief, kAslant, window, 0, 24);
  const Frame frame = relief_frame(planes, relief, kAslant, window, scale_view(planes, window));
  for (size_t i = 0; i < rows.size(); ++i) {
    const glsl::vec4& value = frame.values.data()[i];
    EXPECT_EQ(rows.data()[i], V3f(value.x, value.y, value.z));
  }
  // Rows do not depend on how they are cut.
  const Image<V3f> part = render_relief_rows(planes, relief, kAslant, window, 7, 12);
  EXPECT_TRUE(std::equal(part.begin(), part.end(), rows.row(7)));
}

TEST(ReliefWindow, RefusesWhatIsNotThere) {
  const ScaleTile flat = random_scale({32, 32}, 1, Contents::moved, 1);
  EXPECT_THROW(relief_planes(flat.input(), {.depth_px = 4}, kLight), Error);
  const HighTile tile = tile_of({32, 32}, [](int, int) { return 0.5; });
  EXPECT_THROW(tile.relief({.depth_px = 4, .shade_by = ShadeBy::normal}), Error);
  EXPECT_THROW(tile.relief({.depth_px = 4}, {1, 0, 0}), Error);
}

}  // namespace
}  // namespace texbake
