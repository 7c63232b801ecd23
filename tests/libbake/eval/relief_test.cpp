#include "libbake/eval/relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "libbake/eval/program_of.h"
#include "libbake/eval/relief_window.h"
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
  StackPlanes stack() const { return prepare_stack({{input(), nullptr}}); }
  EvaluatorPlanes planes() const { return prepare(input()); }
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

TEST(Relief, AFlatHeightGivesNoRelief) {
  for (const double height : {0.0, 0.4, 1.0}) {
    const HighTile tile = tile_of({32, 32}, [&](int, int) { return height; });
    const EvaluatorPlanes planes = tile.planes();
    const StackPlanes stack = tile.stack();
    const Relief relief(planes, {.depth_px = 20}, kLight);
    const Window window = window_of_side(40);
    EXPECT_TRUE(render_relief_rows(stack, relief, kAslant, window, 0, 40) == render_stack_rows(stack, window, 0, 40));
  }
}

TEST(Relief, SeenFromAboveNothingMoves) {
  const HighTile tile = tile_of({32, 32}, [](int x, int y) { return (x * 7 + y * 3) % 10 / 10.0; });
  const EvaluatorPlanes planes = tile.planes();
  const StackPlanes stack = tile.stack();
  const Relief relief(planes, {.depth_px = 20, .shade_by = ShadeBy::none}, kLight);
  const Window window = window_of_side(40);
  EXPECT_TRUE(render_relief_rows(stack, relief, {0, 0, 1}, window, 0, 40) == render_stack_rows(stack, window, 0, 40));
}

/// Where the ray through (x, y), on the plane of height `plane`, first meets the surface: in steps of 1/2000 of the
/// depth.
double slow_hit(const std::function<double(double, double)>& height, double x, double y, double plane, double slope_x,
                double slope_y) {
  for (double level = 1; level > 0; level -= 1.0 / 2000)
    if (height(x + slope_x * (plane - level), y + slope_y * (plane - level)) >= level) return level;
  return 0;
}

TEST(Relief, ARayMeetsTheSurfaceWhereASlowWalkDoes) {
  const auto of = [](double x, double y) {
    return 0.5 + 0.3 * std::sin(2 * M_PI * x / 32) + 0.2 * std::cos(2 * M_PI * y / 32);
  };
  const HighTile tile = tile_of({32, 32}, [&](int x, int y) { return of(x + 0.5, y + 0.5); });
  const EvaluatorPlanes planes = tile.planes();
  const Relief relief(planes, {.depth_px = 8, .linear_steps = 64}, kLight);
  glsl::Program program = program_of(planes, 0);
  relief.bind(program);
  const double slope_x = -0.5 / 0.8 * 8, slope_y = 0.3 / 0.8 * 8;
  for (int i = 0; i < 300; ++i) {
    const double x = i * 37 % 32 + 0.25, y = i * 11 % 32 + 0.75;
    const glsl::Position at{{5, 5}, {static_cast<int>(x * 256), static_cast<int>(y * 256)}};
    const glsl::Position met = relief.met(program, at, kAslant);
    const double level = slow_hit(of, x, y, relief.range().z, slope_x, slope_y);
    const double dx = (static_cast<int>(met.tile.x - 5) * 32 * 256 + met.offset.x - at.offset.x) / 256.0;
    // A bilinear surface is off the smooth one by h''/8 = 0.0015, a ray of slope 6 by 0.01 texels; it may graze.
    EXPECT_NEAR(dx, slope_x * (relief.range().z - level), 0.1) << x << " " << y;
  }
}

TEST(Relief, WhatRisesTowardsTheViewerHidesWhatIsBehind) {
  // A wall of height 1 at x = 16 … 17 on a floor of height 0; seen from the left, its far side is hidden.
  const HighTile tile = tile_of({32, 32}, [](int x, int) { return x == 16 ? 1 : 0; });
  const EvaluatorPlanes planes = tile.planes();
  const Relief relief(planes, {.depth_px = 4, .linear_steps = 64}, kLight);
  glsl::Program program = program_of(planes, 0);
  relief.bind(program);
  const Direction from_left{-1, 0, 1};
  for (int x = 0; x < 32 * 256; x += 40) {
    const glsl::Position met = relief.met(program, {{9, 9}, {x, 16 * 256}}, from_left);
    EXPECT_FALSE(met.offset.x > 18 * 256 && met.offset.x < 19 * 256) << x;
  }
}

TEST(Relief, SlopesTowardsTheLightAreBright) {
  const HighTile tile = tile_of({32, 32}, [](int x, int) { return 0.5 + 0.5 * std::sin(2 * M_PI * x / 32); });
  const EvaluatorPlanes planes = tile.planes();
  const Relief relief(planes, {.depth_px = 10, .ambient = 0}, {-1, 0, 1});
  glsl::Program program = program_of(planes, 0);
  relief.bind(program);
  EXPECT_GT(relief.light_at(program, {{0, 0}, {128, 128}}), 1.1f);             // rises to the right, faces left
  EXPECT_LT(relief.light_at(program, {{0, 0}, {16 * 256 + 128, 128}}), 0.7f);  // falls to the right
}

TEST(Relief, ANormalMapOfTheHeightsShadesAsTheHeightsDo) {
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
  const EvaluatorPlanes planes = tile.planes();
  const Relief by_height(planes, {.depth_px = 6}, kLight);
  const Relief by_normal(planes, {.depth_px = 6, .shade_by = ShadeBy::normal}, kLight);
  glsl::Program program = program_of(planes, 0);
  by_height.bind(program);
  for (int x = 0; x < 32; ++x) {
    const glsl::Position at{{0, 0}, {x * 256 + 128, 7 * 256 + 128}};
    EXPECT_NEAR(by_height.light_at(program, at), by_normal.light_at(program, at), 1e-5);
  }
}

TEST(Relief, RefusesWhatIsNotThere) {
  const EvaluatorPlanes flat = random_scale({32, 32}, 1, Contents::moved, 1).tile.planes();
  EXPECT_THROW(Relief(flat, {.depth_px = 4}, kLight), Error);
  const EvaluatorPlanes planes = tile_of({32, 32}, [](int, int) { return 0.5; }).planes();
  EXPECT_THROW(Relief(planes, {.depth_px = 4, .shade_by = ShadeBy::normal}, kLight), Error);
  EXPECT_THROW(Relief(planes, {.depth_px = 4}, {1, 0, 0}), Error);
}

}  // namespace
}  // namespace texbake
