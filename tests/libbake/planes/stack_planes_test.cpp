#include "libbake/planes/stack_planes.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "libbake/planes/box_mean.h"
#include "libbake/planes/transfer_error.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

using glsl::Program;
using glsl::Texel;
using glsl::vec4;

/// Texel (x, y) of the infinite texture of `size`; coordinates of any sign.
Texel texel_of(int64_t x, int64_t y, V2i size) {
  const auto tile = [](int64_t a, int n) { return (a - ((a % n) + n) % n) / n; };
  const auto rest = [](int64_t a, int n) { return static_cast<int>(((a % n) + n) % n); };
  return {{static_cast<uint32_t>(tile(x, size.x)), static_cast<uint32_t>(tile(y, size.y))},
          {rest(x, size.x), rest(y, size.y)}};
}

int64_t floor_div(int64_t a, int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// What a scale shows by itself.
vec4 alone(Program program, int scale, const Texel& at) {
  program.use_scale(scale);
  return program.source_value(program.base, program.texel_source(at));
}

vec4 mean_of(const StackPlanes& planes, int scale) { return planes.color_table(1, scale + 2); }

/// The repetition in which (x, y) lies: the evaluator counts from there.
glsl::uvec2 near(int64_t x, int64_t y, V2i size) { return texel_of(x, y, size).tile; }

constexpr std::pair<int64_t, int64_t> kPlaces[] = {
    {0, 0}, {-40, -70}, {123456789, -987654321}, {-30000000000, 30000000000}};

TEST(StackPlanes, ATexelTakesTheColorOfTheCoarseTexelThatHoldsIt) {
  const StackPlanes planes = two_scales({.ratio = 5, .mode = TransferMode::texel}).planes();
  for (const auto& [x0, y0] : kPlaces) {
    Program program = program_of(planes, 7, near(x0, y0, planes.sizes[1]));
    for (int64_t y = y0 - 20; y < y0 + 20; ++y)
      for (int64_t x = x0 - 20; x < x0 + 20; ++x) {
        const Texel fine = texel_of(x, y, planes.sizes[1]);
        const Texel coarse = texel_of(floor_div(x, 5), floor_div(y, 5), planes.sizes[0]);
        const vec4 expected = alone(program, 1, fine) + (alone(program, 0, coarse) - mean_of(planes, 1));
        ASSERT_EQ(program.scale_texel(1, fine, 1), expected) << x << " " << y;
      }
  }
}

TEST(StackPlanes, AFragmentTakesTheColorAtItsCenter) {
  const SmallStack stack = two_scales({.ratio = 3});
  const StackPlanes planes = stack.planes();
  const ScaleTile& fine_tile = stack.tiles.back();
  const Partition& fragments = fine_tile.fragments.partition;
  const V2i size = planes.sizes[1];
  for (const auto& [x0, y0] : kPlaces) {
    Program program = program_of(planes, 7, near(x0, y0, size));
    for (int64_t y = y0 - 20; y < y0 + 20; ++y)
      for (int64_t x = x0 - 20; x < x0 + 20; ++x) {
        const Texel fine = texel_of(x, y, size);
        program.use_scale(1);
        // Moved contents keep offsets: the center lies as far away as in the tile.
        const glsl::ivec2 source = program.texel_source(fine).nearest;
        const uint32_t idx = fragments.idx(source.x, source.y);
        const OwnerOffset owner = fragments.owner(source.x, source.y);
        const V2i way = fragments.centers[idx] + V2i(owner.x, owner.y) * size - V2i(source.x, source.y);
        const Texel coarse = texel_of(floor_div(x + way.x, 3), floor_div(y + way.y, 3), planes.sizes[0]);
        const vec4 expected = alone(program, 1, fine) + (alone(program, 0, coarse) - mean_of(planes, 1));
        ASSERT_EQ(program.scale_texel(1, fine, 1), expected) << x << " " << y;
      }
  }
}

TEST(StackPlanes, AFragmentKeepsOneColorInsideTurnedContents) {
  // Patches of 16 texels show less than the tile at half their size: each fragment is in a content once.
  SmallStack stack;
  stack.add(random_scale({32, 32}, 3, Contents::moved, 4));
  stack.add(random_scale({64, 64}, 5, Contents::turned, 5), {.ratio = 3});
  const StackPlanes planes = stack.planes();
  const Partition& fragments = stack.tiles.back().fragments.partition;
  Program program = program_of(planes, 3, {0, 0});
  std::map<std::tuple<int, uint32_t, uint32_t, uint32_t>, Texel> anchors;
  int turned = 0;
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      program.use_scale(1);
      const Texel at = texel_of(x, y, planes.sizes[1]);
      const glsl::Decision decision = program.decide(at);
      const glsl::Source source = program.source_of(at, decision);
      turned += source.matrix.y != 0;
      const Program::Shown shown = program.shown_texel(1, at, 1);
      const auto key = std::make_tuple(decision.patch_idx, at.tile.x + static_cast<uint32_t>(decision.owner.x),
                                       at.tile.y + static_cast<uint32_t>(decision.owner.y),
                                       fragments.idx(source.nearest.x, source.nearest.y));
      Texel center = shown.anchor;  // in the frame of tile (0, 0)
      center.p = {center.p.x + static_cast<int>(at.tile.x) * 64, center.p.y + static_cast<int>(at.tile.y) * 64};
      const auto [known, fresh] = anchors.try_emplace(key, center);
      EXPECT_TRUE(fresh || (known->second.p.x == center.p.x && known->second.p.y == center.p.y)) << x << " " << y;
    }
  EXPECT_GT(turned, 5000);
}

TEST(StackPlanes, InATurnedContentTheCenterIsWhereItsTexelShows) {
  const SmallStack stack = two_scales({.ratio = 3}, Contents::turned, 4);
  const StackPlanes planes = stack.planes();
  const Partition& fragments = stack.tiles.back().fragments.partition;
  Program program = program_of(planes, 3, {0, 0});
  const V2i size = planes.sizes[1];
  int checked = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      program.use_scale(1);
      const Texel at = texel_of(x, y, size);
      const glsl::Decision decision = program.decide(at);
      const glsl::Source source = program.source_of(at, decision);
      const V2i center = fragments.centers[fragments.idx(source.nearest.x, source.nearest.y)];
      if (V2i(source.nearest.x, source.nearest.y) != center) continue;
      // The texel that shows the center is less than a texel from where the center is said to be: one texel of the tile
      // is at most one texel of the texture (lambda <= 1).
      const Program::Shown shown = program.shown_texel(1, at, 1);
      EXPECT_LE(std::abs(shown.anchor.p.x - at.p.x), 1);
      EXPECT_LE(std::abs(shown.anchor.p.y - at.p.y), 1);
      ++checked;
    }
  EXPECT_GT(checked, 20);
}

TEST(StackPlanes, TheMeanOverWholeTilesIsTheCoarseColor) {
  SmallStack stack;
  stack.add(random_scale({32, 32}, 3, Contents::moved, 1));
  ScaleTile fine = random_scale({16, 16}, 1, Contents::moved, 2);
  stack.add(std::move(fine), {.ratio = 16, .mode = TransferMode::texel});
  const TransferError error = transfer_error(stack.planes(), 1, 8);
  EXPECT_LT(error.worst, 4e-6);  // values up to 8: a few roundings of 2^-23 each
  EXPECT_EQ(error.coarse_texels, 64);
}

TEST(StackPlanes, TheLocalMeanKeepsTheCoarseColorBetterThanTheTiles) {
  const auto rms = [](DetailMean mean) {
    SmallStack stack;
    stack.add(random_scale({32, 32}, 3, Contents::moved, 1));
    ScaleTile fine = random_scale({64, 64}, 1, Contents::moved, 2);
    for (int y = 0; y < 64; ++y)  // a wave that a footprint of 8 texels sees a part of
      for (int x = 0; x < 64; ++x) fine.tile.base(x, y) = V3f(x < 32 ? 0.25f : 0.75f);
    stack.add(std::move(fine), {.ratio = 8, .mode = TransferMode::texel, .detail_mean = mean});
    return transfer_error(stack.planes(), 1, 16).rms;
  };
  EXPECT_LT(rms(DetailMean::local), 0.5 * rms(DetailMean::tile));
}

TEST(StackPlanes, PlanesWithALocalMeanShowEither) {
  for (const int border : {0, 2}) {
    const auto prepared = [&](DetailMean mean) {
      SmallStack stack = two_scales({.ratio = 4, .detail_mean = mean});
      for (ScaleTile& scale : stack.tiles) scale.tile.soft_border_px = border;
      return stack.planes();
    };
    const StackPlanes tile = prepared(DetailMean::tile), local = prepared(DetailMean::local);
    StackPlanes either = prepared(DetailMean::local);
    const auto rms = [](const StackPlanes& planes) { return transfer_error(planes, 1, 8).rms; };
    set_detail_mean(either, 1, DetailMean::tile);
    EXPECT_EQ(rms(either), rms(tile)) << border;
    set_detail_mean(either, 1, DetailMean::local);
    EXPECT_EQ(rms(either), rms(local)) << border;
    EXPECT_NE(rms(tile), rms(local)) << border;
  }
}

TEST(StackPlanes, RelativeDetailIsInProportionToTheCoarsestScale) {
  SmallStack absolute, relative;
  for (SmallStack* stack : {&absolute, &relative}) {
    stack->add(random_scale({32, 32}, 3, Contents::moved, 1));
    for (V3f& color : stack->tiles.front().tile.base) color = V3f(0.25f, 0.5f, 0.125f);
    stack->add(random_scale({16, 16}, 3, Contents::moved, 2),
               {.ratio = 4, .detail = stack == &relative ? DetailStrength::relative : DetailStrength::absolute});
  }
  const StackPlanes planes = relative.planes();
  Program program = program_of(planes, 7, {0, 0});
  const SmallTile& fine = relative.tiles.back().tile;
  Imath::V3d mean(0);
  for (const V3f& color : fine.base) mean += Imath::V3d(color) / 256.0;
  // A flat coarse color, times the fine one in proportion to its mean.
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const Texel at = texel_of(x, y, {16, 16});
      program.use_scale(1);
      const glsl::ivec2 source = program.texel_source(at).nearest;
      const V3f& own = fine.base(source.x, source.y);
      const vec4 found = program.scale_texel(1, at, 1);
      EXPECT_NEAR(found.x, 0.25 * double{own.x} / mean.x, 1e-6);
      EXPECT_NEAR(found.y, 0.5 * double{own.y} / mean.y, 1e-6);
      EXPECT_NEAR(found.z, 0.125 * double{own.z} / mean.z, 1e-6);
    }
  EXPECT_GT(transfer_error(absolute.planes(), 1, 8).below_black, 0.3);
  EXPECT_EQ(transfer_error(planes, 1, 8).below_black, 0);
}

TEST(StackPlanes, LocalMeansAreThoseOfTheBox) {
  const Image<V3f> tile = random_base({12, 7}, 3);
  for (const int side : {1, 2, 5, 30}) {
    const Image<vec4> means = box_means(tile, side);
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 12; ++x) {
        Imath::V3d sum(0);
        for (int j = 0; j < side; ++j)
          for (int i = 0; i < side; ++i) sum += Imath::V3d(tile(wrap(x + i - side / 2, 12), wrap(y + j - side / 2, 7)));
        EXPECT_NEAR(means(x, y).y, sum.y / (side * side), 1e-6);
      }
  }
}

TEST(StackPlanes, TheReferenceRepetitionDoesNotMatter) {
  const StackPlanes planes = two_scales({.ratio = 5}).planes();
  Program here = program_of(planes, 1, {0, 0}), elsewhere = program_of(planes, 1, {0xffffff00u, 77});
  for (int i = 0; i < 2000; ++i) {
    const Texel at = texel_of(i * 7 - 5000, 3000 - i * 5, planes.sizes[1]);
    ASSERT_EQ(here.scale_texel(1, at, 1), elsewhere.scale_texel(1, at, 1));
  }
}

TEST(StackPlanes, ThreeScalesAreTwoStepsOfEquation5) {
  SmallStack stack = two_scales({.ratio = 2, .mode = TransferMode::texel});
  stack.add(random_scale({16, 16}, 3, Contents::moved, 9), {.ratio = 3, .mode = TransferMode::texel});
  const StackPlanes planes = stack.planes();
  Program program = program_of(planes, 5, {0, 0});
  for (int y = -30; y < 30; ++y)
    for (int x = -30; x < 30; ++x) {
      const Texel fine = texel_of(x, y, planes.sizes[2]),
                  middle = texel_of(floor_div(x, 3), floor_div(y, 3), planes.sizes[1]);
      const vec4 two = program.scale_texel(1, middle, 1);
      const vec4 expected = alone(program, 2, fine) + (two - mean_of(planes, 2));
      const vec4 found = program.scale_texel(2, fine, 1);
      EXPECT_NEAR(found.x, expected.x, 2e-6);  // the sums run the other way round
      EXPECT_NEAR(found.z, expected.z, 2e-6);
    }
}

TEST(StackPlanes, AClassThatTakesNothingKeepsItsColor) {
  const SmallStack stack = two_scales({.ratio = 3, .weights = {0, 1}});
  const StackPlanes planes = stack.planes();
  Program program = program_of(planes, 1, {0, 0});
  int kept = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const Texel at = texel_of(x, y, planes.sizes[1]);
      program.use_scale(1);
      const glsl::ivec2 source = program.texel_source(at).nearest;
      const FragmentMap& fragments = stack.tiles.back().fragments;
      if (fragments.fragments[fragments.partition.idx(source.x, source.y)].class_idx != 0) continue;
      EXPECT_EQ(program.scale_texel(1, at, 1), alone(program, 1, at));
      ++kept;
    }
  EXPECT_GT(kept, 100);
}

TEST(StackPlanes, WithoutVariationAScaleIsItsDominantColors) {
  const SmallStack stack = two_scales({.ratio = 3});
  const StackPlanes planes = stack.planes();
  Program program = program_of(planes, 1, {0, 0});
  program.use_scale(1);
  const glsl::ivec4 labels(0, 0, 0, 1);
  const vec4 dominant = program.with_variation({7, 8, 9, 0}, labels.w, 0);
  EXPECT_EQ(dominant.x, planes.color_table(2 + 1, 0).x);
  EXPECT_EQ(program.with_variation({7, 8, 9, 0}, 1, 1), vec4(7, 8, 9, 0));
  EXPECT_EQ(program.detail_mean(1, {0, 0}, 0).y, planes.color_table(0, 1 + 2).y);
}

TEST(StackPlanes, SoftlyTakenColorsAreContinuousWhereTexelsAreNot) {
  SmallStack stack;
  ScaleTile coarse = random_scale({32, 32}, 1, Contents::moved, 1);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) coarse.tile.base(x, y) = V3f(static_cast<float>(x) / 32);
  ScaleTile fine = random_scale({16, 16}, 1, Contents::moved, 2);
  for (V3f& color : fine.tile.base) color = V3f(0.5f);
  stack.add(std::move(coarse)).add(std::move(fine), {.ratio = 8, .mode = TransferMode::bilinear});
  const StackPlanes planes = stack.planes();
  Program program = program_of(planes, 0, {0, 0});
  for (int x = 8; x < 200; ++x) {
    const float here = program.scale_texel(1, texel_of(x, 20, {16, 16}), 1).x;
    const float next = program.scale_texel(1, texel_of(x + 1, 20, {16, 16}), 1).x;
    EXPECT_NEAR(next - here, 1.0f / 256, 1e-3) << x;  // an eighth of a coarse step; positions are in 1/256
  }
}

TEST(StackPlanes, RefusesWhatDoesNotFit) {
  const auto refused = [](const ScaleTransfer& transfer) {
    try {
      two_scales(transfer).planes();
    } catch (const Error& error) {
      return error.kind() == ErrorKind::bad_data;
    }
    return false;
  };
  EXPECT_TRUE(refused({.ratio = 1}));
  EXPECT_TRUE(refused({.ratio = 1025}));
  EXPECT_TRUE(refused({.weights = {1}}));
  EXPECT_TRUE(refused({.weights = {1, NAN}}));
  EXPECT_FALSE(refused({.ratio = 2}));
  SmallStack wrong_order;
  wrong_order.add(random_scale({16, 16}, 1, Contents::moved, 1));
  wrong_order.add(random_scale({64, 64}, 1, Contents::moved, 1), {.ratio = 2});
  EXPECT_THROW(wrong_order.planes(), Error);
}

}  // namespace
}  // namespace texbake
