#include "libbake/tile/periodic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "libbake/tile/resample.h"
#include "tests/libbake/color/torus_noise.h"

namespace texbake {
namespace {

using ::testing::HasSubstr;

PeriodicOptions options_of(Periodic periodic, int multiple) {
  PeriodicOptions options;
  options.periodic = periodic;
  options.multiple = multiple;
  return options;
}

TEST(Periodic, TorusIsTakenAsItIs) {
  const Image<V3f> torus = torus_noise(128, 64, 3, 1);
  const TilePlan plan = plan_tile(torus);
  EXPECT_FALSE(plan.is_cut());
  EXPECT_FALSE(plan.is_resampled());
  EXPECT_EQ(plan.cut_ratio, 1);
  EXPECT_EQ(apply(plan, torus), torus);
}

TEST(Periodic, PlantedTileIsRecoveredFromAShiftedCrop) {
  const Image<V3f> torus = torus_noise(128, 64, 3, 2);
  const Image<V3f> source = window_of(torus, {37, 11}, 170, 90);
  const TilePlan plan = plan_tile(source);
  EXPECT_FALSE(plan.before.x.tiles());
  EXPECT_EQ(plan.size(), V2i(128, 64));
  EXPECT_FALSE(plan.is_resampled());
  EXPECT_EQ(apply(plan, source), window_of(torus, V2i(37, 11) + plan.tile_from_source(), 128, 64));
  EXPECT_TRUE(plan.after.tiles());
  EXPECT_NEAR(plan.cut_ratio, 1, 0.25);  // a cut through a perfect repetition joins true neighbors, on few pairs
}

TEST(Periodic, CutsJoinBetterThanTheStraightBorder) {
  const Image<V3f> source = window_of(torus_noise(400, 400, 3, 3), {0, 0}, 300, 260);
  const TilePlan plan = plan_tile(source, options_of(Periodic::automatic, 32));
  ASSERT_TRUE(plan.x.cut && plan.y.cut);
  EXPECT_EQ(plan.x.size % 32, 0);
  EXPECT_EQ(plan.y.size % 32, 0);
  EXPECT_FALSE(plan.is_resampled());
  EXPECT_TRUE(plan.after.tiles());
  EXPECT_LT(plan.cut_ratio, 0.6 * std::min(plan.before.x.ratio, plan.before.y.ratio));
}

TEST(Periodic, EveryTexelShowsTheSourceAtItsPlaceModuloThePeriod) {
  const Image<V3f> source = window_of(torus_noise(200, 200, 2, 4), {0, 0}, 150, 140);
  const TilePlan plan = plan_tile(source, options_of(Periodic::make, 16));
  const Image<V3f> tile = apply(plan, source);
  for (int y = 0; y < plan.y.length; ++y)
    for (int x = 0; x < plan.x.length; ++x) {
      const V2i place = plan.source_place({x, y});
      ASSERT_EQ(wrap(place.x - plan.x.begin - x, plan.x.length), 0);
      ASSERT_EQ(wrap(place.y - plan.y.begin - y, plan.y.length), 0);
      if (x >= plan.x.overlap && y >= plan.y.overlap) {  // elsewhere the shade may have been leveled
        ASSERT_EQ(tile(x, y), source(place.x, place.y));
      }
    }
}

TEST(Periodic, SlopeOfShadeIsSpreadOverTheSeam) {
  // a texture under light that doubles from left to right: a hard cut would show as a line
  Image<V3f> source = window_of(torus_noise(300, 200, 2, 14), {0, 0}, 240, 160);
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 240; ++x) source(x, y) *= 0.5f + 0.5f * static_cast<float>(x) / 240;
  const TilePlan plan = plan_tile(source, options_of(Periodic::make, 32));
  const Image<V3f> tile = apply(plan, source);
  double hard = 0, levelled = 0;  // mean signed step from the left of the cut to its right
  for (int y = plan.y.overlap; y < plan.y.length; ++y) {
    const int x = plan.cut_x[y];
    const V2i left = plan.source_place({x - 1, y}), right = plan.source_place({x, y});
    hard += source(right.x, right.y).y - source(left.x, left.y).y;
    levelled += tile(x, y).y - tile(x - 1, y).y;
  }
  EXPECT_GT(std::abs(hard), 8 * std::abs(levelled));
}

// Across the straight border of the tile, sources follow each other as they do inside: the seam is along the cut.
TEST(Periodic, StraightBorderOfACutTileIsNoSeam) {
  const Image<V3f> source = window_of(torus_noise(200, 200, 2, 4), {0, 0}, 150, 140);
  const TilePlan plan = plan_tile(source, options_of(Periodic::make, 16));
  for (int y = 0; y < plan.y.length; ++y) {
    const V2i last = plan.source_place({plan.x.length - 1, y}), first = plan.source_place({0, y});
    EXPECT_EQ(first.x, last.x + 1) << y;
  }
  for (int x = 0; x < plan.x.length; ++x) {
    const V2i last = plan.source_place({x, plan.y.length - 1}), first = plan.source_place({x, 0});
    EXPECT_EQ(first.y, last.y + 1) << x;
  }
}

TEST(Periodic, OnlyTheAxisThatDoesNotTileIsCut) {
  const Image<V3f> source = window_of(torus_noise(128, 200, 3, 5), {0, 0}, 128, 150);
  const TilePlan plan = plan_tile(source);
  EXPECT_FALSE(plan.x.cut);
  EXPECT_TRUE(plan.y.cut);
  EXPECT_EQ(plan.x.size, 128);
  EXPECT_TRUE(plan.cut_x.empty());
  EXPECT_TRUE(measure_seam(apply(plan, source)).tiles());
}

TEST(Periodic, AssumeNeverCutsAndMakeAlwaysDoes) {
  const Image<V3f> torus = torus_noise(128, 128, 3, 6);
  const Image<V3f> crop = window_of(torus, {0, 0}, 100, 96);
  EXPECT_FALSE(plan_tile(crop, options_of(Periodic::assume, 1)).is_cut());
  const TilePlan made = plan_tile(torus, options_of(Periodic::make, 32));
  EXPECT_TRUE(made.x.cut && made.y.cut);
}

TEST(Periodic, AssumedTileIsResampledToTheNearestMultiple) {
  const Image<V3f> torus = torus_noise(250, 125, 4, 7);
  const TilePlan plan = plan_tile(torus, options_of(Periodic::assume, 64));
  EXPECT_EQ(plan.size(), V2i(256, 128));
  EXPECT_TRUE(plan.is_resampled());
  EXPECT_TRUE(plan.after.tiles());
  EXPECT_EQ(plan_tile(torus, options_of(Periodic::assume, 1)).size(), V2i(250, 125));
  // 96 to a multiple of 64 would stretch by a third: 96 = 3 · 32 is kept
  EXPECT_EQ(plan_tile(window_of(torus, {0, 0}, 96, 48), options_of(Periodic::assume, 64)).size(), V2i(96, 48));
}

TEST(Periodic, PatternIsClosedAtItsOwnPeriodAndResampled) {
  const Image<V3f> source = window_of(torus_noise(122, 64, 3, 8), {9, 0}, 180, 64);
  const TilePlan plan = plan_tile(source);
  EXPECT_EQ(plan.x.length, 122);
  EXPECT_EQ(plan.x.size, 128);
  EXPECT_TRUE(plan.after.tiles());
}

TEST(Periodic, AllMapsFollowTheColor) {
  const Image<V3f> source = window_of(torus_noise(200, 200, 2, 9), {0, 0}, 150, 140);
  Image<float> height(150, 140);
  for (size_t i = 0; i < height.size(); ++i) height.data()[i] = source.data()[i].y;
  const TilePlan plan = plan_tile(source, options_of(Periodic::make, 16));
  const Image<V3f> tile = apply(plan, source);
  const Image<float> height_tile = apply(plan, height);
  for (size_t i = 0; i < tile.size(); ++i) ASSERT_EQ(height_tile.data()[i], tile.data()[i].y);
}

TEST(Periodic, MapsOfAnotherSizeAreResampledToTheColor) {
  const Image<V3f> source = window_of(torus_noise(200, 200, 4, 10), {0, 0}, 150, 140);
  const TilePlan plan = plan_tile(source, options_of(Periodic::make, 16));
  const Image<V3f> half = resample(source, 75, 70, {Wrap::clamp, Wrap::clamp});
  const Image<V3f> tile = apply(plan, source), from_half = apply(plan, half);
  ASSERT_TRUE(same_size(tile, from_half));
  double error = 0;
  for (size_t i = 0; i < tile.size(); ++i) error += (tile.data()[i] - from_half.data()[i]).length();
  EXPECT_LT(error / static_cast<double>(tile.size()), 0.04);  // the grain, 0.05 wide in each channel, is lost
}

TEST(Periodic, ResampledNormalsAreUnitVectors) {
  Image<V3f> normals(120, 120);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) normals(x, y) = V3f(std::sin(0.4f * static_cast<float>(x)), 0.3f, 1).normalized();
  const TilePlan plan = plan_tile(torus_noise(120, 120, 3, 11), options_of(Periodic::assume, 64));
  ASSERT_EQ(plan.size(), V2i(128, 128));
  for (const V3f& normal : apply_to_normals(plan, normals)) ASSERT_NEAR(normal.length(), 1, 1e-6);  // rounding
  const TilePlan as_it_is = plan_tile(torus_noise(120, 120, 3, 11), options_of(Periodic::assume, 1));
  EXPECT_EQ(apply_to_normals(as_it_is, normals), normals);
}

TEST(Periodic, ThreadsDoNotChangeThePlan) {
  const Image<V3f> source = window_of(torus_noise(200, 200, 2, 12), {0, 0}, 150, 140);
  const TilePlan expected = plan_tile(source);
  for (const size_t threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const TilePlan plan = plan_tile(source);
    EXPECT_EQ(plan.cut_x, expected.cut_x);
    EXPECT_EQ(plan.cut_y, expected.cut_y);
    EXPECT_EQ(plan.cut_ratio, expected.cut_ratio);
    EXPECT_EQ(apply(plan, source), apply(expected, source));
  }
}

TEST(Periodic, ConstantExemplarStaysConstant) {
  const Image<V3f> gray(100, 90, V3f(0.25f));
  for (const Periodic periodic : {Periodic::automatic, Periodic::assume, Periodic::make}) {
    const TilePlan plan = plan_tile(gray, options_of(periodic, 64));
    for (const V3f& texel : apply(plan, gray)) ASSERT_EQ(texel, V3f(0.25f));
  }
}

TEST(Periodic, SmallestExemplarCanBeClosed) {
  const Image<V3f> source = window_of(torus_noise(64, 64, 2, 13), {0, 0}, 32, 32);
  const TilePlan plan = plan_tile(source, options_of(Periodic::make, 64));
  EXPECT_GE(plan.x.size, 16);
  EXPECT_LE(plan.x.size, 32);
}

TEST(Periodic, WhatCannotBeATileIsRefused) {
  const auto kind_and_words = [](int width, int height, const PeriodicOptions& options) -> std::pair<int, std::string> {
    try {
      plan_tile(Image<V3f>(width, height), options);
    } catch (const Error& error) {
      return {static_cast<int>(error.kind()), error.what()};
    }
    return {-1, ""};
  };
  const auto [small_kind, small_words] = kind_and_words(1, 1, {});
  EXPECT_EQ(small_kind, static_cast<int>(ErrorKind::bad_data));
  EXPECT_THAT(small_words, HasSubstr("at least 32 x 32 texels, found 1 x 1"));
  EXPECT_EQ(kind_and_words(31, 500, {}).first, static_cast<int>(ErrorKind::bad_data));

  PeriodicOptions wide = options_of(Periodic::make, 64);
  wide.overlap_px = 80;
  const auto [wide_kind, wide_words] = kind_and_words(128, 128, wide);
  EXPECT_EQ(wide_kind, static_cast<int>(ErrorKind::infeasible));
  EXPECT_THAT(wide_words, HasSubstr("found 80"));
  wide.multiple = 0;
  EXPECT_EQ(kind_and_words(128, 128, wide).first, static_cast<int>(ErrorKind::usage));
}

}  // namespace
}  // namespace texbake
