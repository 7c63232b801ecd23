#include "libbake/planes/stack_levels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/color/luv.h"
#include "libbake/draw/stack_window.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/program_of.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

using glsl::Program;
using glsl::Texel;
using glsl::vec4;
using Imath::V3d;

V3d color_of(const vec4& v) { return {v.x, v.y, v.z}; }

StackPlanes leveled(const SmallStack& stack) {
  StackPlanes planes = stack.planes();
  return planes;
}

/// What a block shows, less the mean of its texels: over some blocks of a level.
struct Difference {
  V3d bias{0};       ///< the mean over the blocks
  double worst = 0;  ///< of one channel of one block
};

Difference difference_at(const StackPlanes& planes, int scale, int level, float variation, int blocks = 12) {
  Program program = program_of(planes, 3, {0, 0});
  Difference difference;
  program.use_scale(scale);
  program.use_levels(scale);
  const glsl::Grid grid = program.grid_of(level);
  const V2i side(grid.side_256.x / 256, grid.side_256.y / 256);
  for (int j = 0; j < blocks; ++j)
    for (int i = 0; i < blocks; ++i) {
      const Texel block{{static_cast<uint32_t>(i / grid.blocks.x), static_cast<uint32_t>(j / grid.blocks.y)},
                        {i % grid.blocks.x, j % grid.blocks.y}};
      V3d sum(0);
      for (int y = 0; y < side.y; ++y)
        for (int x = 0; x < side.x; ++x) {
          const Texel texel{block.tile, {block.p.x * side.x + x, block.p.y * side.y + y}};
          sum += color_of(program.scale_texel(scale, texel, variation));
        }
      program.use_scale(scale);
      program.use_levels(scale);
      const V3d d = color_of(program.scale_block(scale, block, grid, variation)) - sum / (double{1} * side.x * side.y);
      difference.bias += d / (double{1} * blocks * blocks);
      for (int c = 0; c < 3; ++c) difference.worst = std::max(difference.worst, std::abs(d[c]));
    }
  return difference;
}

// Values up to 8, and sums of some of them: a few roundings of 2^-21.
constexpr double kRounded = 1e-5;

TEST(StackLevels, ABlockOfFragmentsIsTheMeanOfItsTexels) {
  for (const DetailMean mean : {DetailMean::tile, DetailMean::local}) {
    const StackPlanes planes = leveled(two_scales({.ratio = 16,
                                                   .detail_mean = mean,
                                                   .weights = {0.3f, 1},
                                                   .coarse_weights = {1, 0.7f},
                                                   .detail_gains = {1.7f, 0.4f}}));
    ASSERT_EQ(planes.level_count(1), 4);
    for (int level = 1; level <= 4; ++level)
      for (const float variation : {1.0f, 0.4f, 0.0f})
        EXPECT_LT(difference_at(planes, 1, level, variation).worst, kRounded) << level << " " << variation;
  }
}

TEST(StackLevels, ABlockOfTurnedContentsIsTheMeanOfItsTexels) {
  const StackPlanes planes = leveled(two_scales({.ratio = 16}, Contents::turned));
  for (int level = 1; level <= 4; ++level) EXPECT_LT(difference_at(planes, 1, level, 1).worst, kRounded) << level;
}

TEST(StackLevels, ABlockOfThreeScalesIsTheMeanOfItsTexels) {
  SmallStack stack = two_scales({.ratio = 3}, Contents::turned);
  stack.add(random_scale({48, 40}, 5, Contents::moved, 8), {.ratio = 6, .detail_mean = DetailMean::local});
  const StackPlanes planes = leveled(stack);
  for (int level = 1; level <= planes.level_count(2); ++level)
    EXPECT_LT(difference_at(planes, 2, level, 1, 8).worst, kRounded) << level;
}

/// With soft borders of patches in every scale.
StackPlanes softened(const SmallStack& stack) {
  std::vector<StackScale> scales = stack.scales();
  for (StackScale& scale : scales) scale.input.soft_border_px = 2;
  return prepare_stack(scales);
}

TEST(StackLevels, ABlockWithSoftBordersIsTheMeanOfItsTexels) {
  const StackPlanes planes = softened(two_scales({.ratio = 16,
                                                  .detail_mean = DetailMean::local,
                                                  .detail = DetailStrength::relative,
                                                  .weights = {0.3f, 1},
                                                  .detail_gains = {1.7f, 0.4f}}));
  for (int level = 1; level <= 4; ++level)
    for (const float variation : {1.0f, 0.4f, 0.0f})
      EXPECT_LT(difference_at(planes, 1, level, variation).worst, kRounded) << level << " " << variation;
}

TEST(StackLevels, ABlockThatTexelsColorIsTheMeanOfThemByParts) {
  // Coarse texels count by 1/256 of a block on each axis; colors differ by 8 at most.
  for (const int ratio : {16, 5}) {
    const StackPlanes planes = leveled(two_scales({.ratio = ratio, .mode = TransferMode::texel}));
    for (int level = 1; level <= planes.level_count(1); ++level)
      EXPECT_LT(difference_at(planes, 1, level, 1).worst, 8 * 2.0 / 256) << level;
  }
}

/// Natural colors, 0 … 1, in a coarse picture that changes smoothly, without contents, and a fine one that does not.
SmallStack natural_stack(TransferMode mode) {
  SmallStack stack;
  ScaleTile coarse = random_scale({64, 64}, 1, Contents::moved, 31),
            fine = random_scale({64, 64}, 3, Contents::moved, 32);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto wave = [&](double phase) {
        return static_cast<float>(0.5 + 0.4 * std::sin(2 * M_PI * (3 * x + 2 * y) / 64 + phase));
      };
      coarse.tile.base(x, y) = half_exact(V3f(wave(0), wave(1), wave(2)));
      fine.tile.base(x, y) = half_exact(fine.tile.base(x, y) * 0.25f);
    }
  stack.add(std::move(coarse)).add(std::move(fine), {.ratio = 16, .mode = mode});
  return stack;
}

TEST(StackLevels, NoTransferDarkensOrLightens) {
  for (const TransferMode mode : {TransferMode::fragment, TransferMode::texel, TransferMode::bilinear}) {
    const StackPlanes planes = leveled(natural_stack(mode));
    for (int level = 1; level <= 4; ++level) {
      const Difference found = difference_at(planes, 1, level, 1, 64);
      for (int c = 0; c < 3; ++c) EXPECT_LT(std::abs(found.bias[c]), 0.5 / 255) << enum_name(mode) << " " << level;
      // Between coarse texels a block takes what its center does: off by the curvature within it alone.
      if (mode != TransferMode::bilinear) continue;
      EXPECT_LT(found.worst, 4.0 / 255) << level;
    }
  }
}

TEST(StackLevels, TheCoarsestScaleHasTheLevelsOfItsBundle) {
  SmallStack stack = two_scales({.ratio = 4}, Contents::turned);
  const StackPlanes planes = leveled(stack);
  EvaluatorPlanes alone = prepare(stack.tiles.front().input());
  Program program = program_of(planes, 7, {0, 0}), single = program_of(alone, 7 + 2654435769u);
  for (int i = 0; i < 500; ++i) {
    const glsl::Position at{{static_cast<uint32_t>(i % 3), static_cast<uint32_t>(i % 5)},
                            {i * 37 % 8192, i * 11 % 4096}};
    const int level_256 = i * 4;
    program.use_scale(0);
    const vec4 found = program.stack_probes_value(stack_probes({0, 0, 1, level_256}, at), 1);
    EXPECT_EQ(found, single.trilinear_value(single.base, 0, sampler_of(alone.base.level_values), at, level_256)) << i;
  }
}

TEST(StackLevels, FadingEndsAtTheCoarserScale) {
  const StackPlanes planes = leveled(natural_stack(TransferMode::fragment));
  Window window;
  window.origin_x = window.origin_y = tile_offset(-77, 0, 64);
  window.width = window.height = 32;
  window.filter = Filter::trilinear;
  window.step_256 = 16 * 256 - 1;
  const Image<V3f> before = render_stack_rows(planes, window, 0, 32);
  window.step_256 = 16 * 256;
  const Image<V3f> after = render_stack_rows(planes, window, 0, 32);
  // A step of 1/4096 moves the last pixel by 1/128 coarse texel, whose colors differ by 0.25 from one to the next.
  for (size_t i = 0; i < after.size(); ++i) EXPECT_LT((before.data()[i] - after.data()[i]).length(), 0.002) << i;
}

TEST(StackLevels, AWindowFromAfarIsTheMeanOfItsTexels) {
  const StackPlanes planes = leveled(natural_stack(TransferMode::fragment));
  Window far;
  far.origin_x = far.origin_y = tile_offset(-64, 0, 64);
  far.width = far.height = 24;
  far.filter = Filter::trilinear;
  far.step_256 = 4 * 256;
  // One scale alone, as it looks at half the way to the next: whole levels, block by block.
  const ScaleView view{1, 0, 1, 2 * 256};
  const Image<V3f> found = render_scale_rows(planes, far, view, 0, 24);
  Window near = far;
  near.step_256 = 256;
  near.filter = Filter::nearest;
  near.width = near.height = 96;
  const Image<V3f> texels = render_scale_rows(planes, near, {1, 0, 1, 0}, 0, 96);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      V3d sum(0);
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) sum += V3d(texels(x * 4 + i, y * 4 + j));
      EXPECT_LT((V3d(found(x, y)) - sum / 16.0).length(), kRounded);
    }
}

TEST(StackLevels, AFlatStackIsFlatAtEveryLevel) {
  SmallStack stack = two_scales({.ratio = 8});
  for (ScaleTile& tile : stack.tiles) {
    for (V3f& color : tile.tile.base) color = V3f(0.25f, 0.5f, 1);
    for (ColorClass& c : tile.colors.palette.classes) c.dominant = luv_from_linear(V3f(0.25f, 0.5f, 1));
  }
  const StackPlanes planes = leveled(stack);
  Window window;
  window.width = window.height = 20;
  window.filter = Filter::trilinear;
  for (const uint32_t step : {256u, 700u, 1500u, 4000u, 200000u}) {
    window.step_256 = step;
    for (const V3f& color : render_stack_rows(planes, window, 0, 20))
      EXPECT_LT((color - V3f(0.25f, 0.5f, 1)).length(), 1e-5);  // CIELUV there and back
  }
}

}  // namespace
}  // namespace texbake
