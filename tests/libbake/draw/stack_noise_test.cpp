// Noise in the finest scale of a stack.
#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/draw/stack_window.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/program_of.h"
#include "libbake/planes/stack_levels.h"
#include "libbake/planes/transfer_error.h"
#include "small_stack.h"
#include "stack_painter.h"

namespace texbake {
namespace {

using glsl::Program;
using glsl::Texel;
using glsl::vec4;
using Imath::V3d;

V3d color_of(const vec4& v) { return {v.x, v.y, v.z}; }

SmallStack noisy_stack(const ScaleTransfer& transfer, int noises, Contents kind = Contents::turned, int border_px = 0,
                       int side = 32, NoiseSpace space = NoiseSpace::root) {
  SmallStack stack;
  stack.add(random_scale({32, 16}, 3, kind, 81));
  stack.add(random_scale({side, side}, 3, kind, 82), transfer);
  add_noise(stack.tiles.back().tile, noises, side, 82, space);
  for (ScaleTile& scale : stack.tiles) scale.tile.soft_border_px = border_px;
  return stack;
}

/// The same without its noise: its structure.
SmallStack structure_of(SmallStack stack) {
  stack.tiles.back().tile.masks.clear();
  return stack;
}

StackPlanes leveled(const SmallStack& stack) {
  StackPlanes planes = stack.planes();
  return planes;
}

Window window_of(int side, uint32_t step_256, Filter filter) {
  Window window;
  window.origin_x = {7, 5 * 256};
  window.origin_y = {0xffffffffu, 3 * 256};
  window.width = window.height = side;
  window.seed = 3;
  window.step_256 = step_256;
  window.filter = filter;
  return window;
}

TEST(StackNoise, AStackOfOneScaleIsThatScale) {
  for (const Contents kind : {Contents::moved, Contents::turned})
    for (const int border_px : {0, 2, 5})
      for (const int noise_side : {16, 64}) {
        SmallStack stack;
        stack.add(random_scale({64, 48}, 3, kind, 83));
        SmallTile& tile = stack.tiles.back().tile;
        add_noise(tile, 3, noise_side, 83);
        tile.soft_border_px = border_px;
        const StackPlanes planes = leveled(stack);
        EvaluatorPlanes single = prepare(tile.input());
        for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear})
          for (const uint32_t step : {200u, 256u, 512u, 700u, 3000u, 20000u}) {
            const Window window = window_of(50, step, filter);
            EXPECT_TRUE(render_stack_rows(planes, window, 0, 50) == render_rows(single, window, 0, 50))
                << "borders of " << border_px << ", noise of " << noise_side << ", step " << step;
          }
      }
}

TEST(StackNoise, TexelsAndBlocksEqualTheSlowPainterBitByBit) {
  const ScaleTransfer plain{.ratio = 8},
      gained{.ratio = 16, .detail_mean = DetailMean::local, .weights = {0.5f, 1}, .detail_gains = {0.5f, 1.75f}};
  for (const Contents kind : {Contents::moved, Contents::turned})
    for (const ScaleTransfer& transfer : {plain, gained}) {
      const SmallStack stack = noisy_stack(transfer, 3, kind);
      const StackPlanes planes = leveled(stack);
      const StackPainter painter(stack, 3);
      for (int level = 0; level <= planes.level_count(1); ++level)
        for (const float variation : {1.0f, 0.5f, 0.0f}) {
          Program program = program_of(planes, 3, {0, 0});
          program.use_scale(1);
          program.use_levels(1);
          const glsl::Grid grid = program.grid_of(level);
          const int side = 32 >> level;
          for (int y = 0; y < 2 * side; y += 3)
            for (int x = 0; x < 2 * side; x += 3) {
              const Texel block{{static_cast<uint32_t>(x / side), static_cast<uint32_t>(y / side)},
                                {x % side, y % side}};
              program.use_scale(1);
              program.use_levels(1);
              const vec4 found = program.scale_block(1, block, grid, variation);
              EXPECT_EQ(V3f(found.x, found.y, found.z), painter.block(x, y, level, variation))
                  << "level " << level << ", block " << x << " " << y << ", variation " << variation;
            }
        }
    }
}

TEST(StackNoise, SoftTexelsEqualTheSlowPainterBitByBit) {
  const SmallStack stack = noisy_stack({.ratio = 4}, 3, Contents::turned, 2);
  const StackPlanes planes = stack.planes();
  const StackPainter painter(stack, 3);
  Program program = program_of(planes, 3, {0, 0});
  for (const float variation : {1.0f, 0.5f, 0.0f})
    for (int y = 0; y < 64; y += 3)
      for (int x = 0; x < 64; ++x) {
        const Texel at{{static_cast<uint32_t>(x / 32), static_cast<uint32_t>(y / 32)}, {x % 32, y % 32}};
        const vec4 found = program.scale_texel(1, at, variation);
        EXPECT_EQ(V3f(found.x, found.y, found.z), painter.texel(1, x, y, variation)) << x << " " << y;
      }
}

TEST(StackNoise, ZeroNoiseIsTheStackOfTheStructure) {
  for (const int border_px : {0, 2}) {
    const ScaleTransfer transfer{.ratio = 8, .detail = DetailStrength::relative, .detail_gains = {0.5f, 3}};
    SmallStack stack = noisy_stack(transfer, 3, Contents::turned, border_px);
    for (Image<V3f>& noise : stack.tiles.back().tile.noises)
      for (V3f& color : noise) color = V3f(0);
    const StackPlanes noisy = leveled(stack), plain = leveled(structure_of(std::move(stack)));
    for (const uint32_t step : {100u, 256u, 600u, 1500u, 9000u}) {
      const Window window = window_of(60, step, Filter::trilinear);
      EXPECT_TRUE(render_stack_rows(noisy, window, 0, 60) == render_stack_rows(plain, window, 0, 60)) << step;
    }
  }
}

TEST(StackNoise, WithoutVariationThereIsNoGrain) {
  const ScaleTransfer transfer{.ratio = 8, .variation = VariationFrom::coarse};
  for (const int border_px : {0, 2}) {
    SmallStack stack = noisy_stack(transfer, 3, Contents::turned, border_px);
    const StackPlanes noisy = leveled(stack), plain = leveled(structure_of(std::move(stack)));
    for (const uint32_t step : {100u, 256u, 600u, 1500u}) {
      const Window window = window_of(60, step, Filter::trilinear);
      EXPECT_TRUE(render_stack_rows(noisy, window, 0, 60) == render_stack_rows(plain, window, 0, 60)) << step;
    }
  }
}

TEST(StackNoise, GrainStaysWhereItIsSeen) {
  // A flat structure on flat coarse colors: what is left is the noise, whatever contents and fragments show.
  SmallStack stack = noisy_stack({.ratio = 4}, 1, Contents::turned, 0, 32, NoiseSpace::linear);
  for (ScaleTile& scale : stack.tiles)
    for (V3f& color : scale.tile.base) color = V3f(0.5f);
  const Image<V3f>& noise = stack.tiles.back().tile.noises[0];
  V3d mean(0);
  for (const V3f& color : noise) mean += V3d(color) / static_cast<double>(noise.size());
  const StackPlanes planes = stack.planes();
  Program program = program_of(planes, 5, {0, 0});
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const Texel at{{static_cast<uint32_t>(x / 32), static_cast<uint32_t>(y / 32)}, {x % 32, y % 32}};
      const size_t n = static_cast<size_t>(x + stack.tiles.back().tile.noise_step * y) % noise.size();
      const V3d expected = V3d(0.5) + V3d(noise.data()[n]) - mean;
      // Two sums of numbers below 1.
      EXPECT_LT((color_of(program.scale_texel(1, at, 1)) - expected).length(), 1e-6);
    }
}

TEST(StackNoise, TheMeanOverWholeTilesIsTheCoarseColor) {
  // Rows of 16 texels under one noise of 16 values: each row has every value once.
  SmallStack stack;
  stack.add(random_scale({32, 32}, 3, Contents::moved, 84));
  stack.add(random_scale({16, 16}, 1, Contents::moved, 85), {.ratio = 16, .mode = TransferMode::texel});
  add_noise(stack.tiles.back().tile, 1, 4, 85, NoiseSpace::linear);
  EXPECT_LT(transfer_error(stack.planes(), 1, 8).worst, 4e-6);  // values up to 8: a few roundings of 2^-23 each
}

TEST(StackNoise, RelativeDetailIsInProportionToTheCoarsestScaleGrainAndAll) {
  SmallStack stack =
      noisy_stack({.ratio = 4, .detail = DetailStrength::relative}, 2, Contents::moved, 0, 32, NoiseSpace::linear);
  for (V3f& color : stack.tiles.front().tile.base) color = V3f(0.25f, 0.5f, 0.125f);
  const StackPlanes planes = stack.planes();
  const SmallTile& fine = stack.tiles.back().tile;
  V3d mean(0);
  for (size_t i = 0; i < fine.base.size(); ++i) mean += V3d(fine.base.data()[i]) / 1024.0;
  for (size_t k = 0; k < 2; ++k) {
    V3d noise(0);
    double mask = 0;
    for (size_t i = 0; i < 1024; ++i) {
      noise += V3d(fine.noises[k].data()[i]) / 1024.0;
      mask += double{fine.masks[k].data()[i]} / 1024.0;
    }
    mean += noise * mask;
  }
  const uint32_t seed = 7;
  const Painting own = Painter(fine, seed).paint(0, 0, 64, 64);
  Program program = program_of(planes, seed, {0, 0});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const V3d found = color_of(program.scale_texel(
          1, {{static_cast<uint32_t>(x / 32), static_cast<uint32_t>(y / 32)}, {x % 32, y % 32}}, 1));
      // Noises of 0.5 at most, times less than 1, are rounded to half: half a step of 2^-12.
      EXPECT_NEAR(found.y, 0.5 * double{own.color(x, y).y} / mean.y, 0x1p-13 + 1e-6);
      EXPECT_NEAR(found.z, 0.125 * double{own.color(x, y).z} / mean.z, 0x1p-13 + 1e-6);
    }
}

/// What a block shows, less the mean of its texels: over two tiles on each axis.
struct Difference {
  V3d bias{0};
  double worst = 0;
};

Difference difference_at(const StackPlanes& planes, int level, float variation) {
  Program program = program_of(planes, 3, {0, 0});
  Difference difference;
  program.use_scale(1);
  program.use_levels(1);
  const glsl::Grid grid = program.grid_of(level);
  const int side = grid.side_256.x / 256, blocks = grid.blocks.x;
  for (uint32_t j = 0; j < 2 * static_cast<uint32_t>(blocks); ++j)
    for (uint32_t i = 0; i < 2 * static_cast<uint32_t>(blocks); ++i) {
      const auto n = static_cast<uint32_t>(blocks);
      const Texel block{{i / n, j / n}, {static_cast<int>(i % n), static_cast<int>(j % n)}};
      V3d sum(0);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          sum +=
              color_of(program.scale_texel(1, {block.tile, {block.p.x * side + x, block.p.y * side + y}}, variation));
      program.use_scale(1);
      program.use_levels(1);
      const V3d d = color_of(program.scale_block(1, block, grid, variation)) - sum / (double{1} * side * side);
      difference.bias += d / (4.0 * blocks * blocks);
      for (int c = 0; c < 3; ++c) difference.worst = std::max(difference.worst, std::abs(d[c]));
    }
  return difference;
}

TEST(StackNoise, ABlockUnderOneNoiseIsTheMeanOfItsTexels) {
  // As in noise_levels_test.cpp: levels of noises of −0.5 … 0.5 are half floats; times a gain of 1.5.
  constexpr double kRounding = 1.5 * 0x1p-12 + 1e-5;
  for (const int border_px : {0, 2}) {
    const StackPlanes planes = leveled(noisy_stack({.ratio = 16, .detail_gains = {1.5f, 1.5f}}, 1, Contents::moved,
                                                   border_px, 32, NoiseSpace::linear));
    for (int level = 1; level <= 4; ++level)
      for (const float variation : {1.0f, 0.4f, 0.0f})
        EXPECT_LT(difference_at(planes, level, variation).worst, kRounding) << level << " " << variation;
  }
}

TEST(StackNoise, LevelsAreWithoutBiasWhateverMasksAndGains) {
  // White noise, masks and classes as fine as texels: the worst that there is. What differs in a block differs both
  // ways.
  SmallStack stacks[] = {
      noisy_stack({.ratio = 16}, 3, Contents::turned, 0, 128),
      noisy_stack({.ratio = 16, .detail_gains = {0.5f, 1.5f}}, 3, Contents::moved, 0, 128, NoiseSpace::linear)};
  // In the root the noise is multiplied with twice that of the structure: by 1 at most, as in light.
  for (V3f& color : stacks[0].tiles.back().tile.base) color = half_exact(color * 0.0625f);
  for (const SmallStack& stack : stacks) {
    const StackPlanes planes = leveled(stack);
    for (int level = 1; level <= 4; ++level) {
      const Difference found = difference_at(planes, level, 1);
      for (int c = 0; c < 3; ++c) EXPECT_LT(std::abs(found.bias[c]), 0.5 / 255) << level;
    }
  }
}

TEST(StackNoise, RefusesNoiseInACoarserScale) {
  SmallStack stack = noisy_stack({.ratio = 4}, 1);
  add_noise(stack.tiles.front().tile, 1, 16, 86);
  EXPECT_THROW(stack.planes(), Error);
}

}  // namespace
}  // namespace texbake
