#include "libbake/planes/levels.h"

#include <gtest/gtest.h>

#include "libbake/draw/frame.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/program_of.h"
#include "tests/libbake/draw/painter.h"

namespace texbake {
namespace {

EvaluatorPlanes leveled(const SmallTile& tile) {
  EvaluatorPlanes planes = tile.planes();
  return planes;
}

/// Float sums of up to 2^12 values in 0 … 4, pairwise: 12 roundings of 2^-24 relative.
constexpr float kRounding = 4 * 12 * 0x1p-24f;

V3f color_of(const glsl::vec4& v) { return {v.x, v.y, v.z}; }

double distance(const V3f& a, const V3f& b) {
  const V3f d = a - b;
  return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

/// The box mean of painted texels, in double.
V3f box_mean(const Painting& painting, int64_t x0, int64_t y0, int side) {
  double sum[3] = {0, 0, 0};
  for (int64_t y = y0; y < y0 + side; ++y)
    for (int64_t x = x0; x < x0 + side; ++x)
      for (int c = 0; c < 3; ++c)
        sum[c] += double{painting.color(static_cast<int>(x - painting.x0), static_cast<int>(y - painting.y0))[c]};
  const auto mean = [&](int c) { return static_cast<float>(sum[c] / side / side); };
  return {mean(0), mean(1), mean(2)};
}

TEST(Levels, EveryBlockIsTheBoxMeanOfThePaintedTexture) {
  uint64_t seed = 40;
  for (const V2i& n : {V2i(32, 32), V2i(64, 96)})
    for (const Contents kind : {Contents::moved, Contents::turned})
      for (const int64_t tile_x : {int64_t{0}, int64_t{-2}, int64_t{1} << 32}) {
        const SmallTile tile = random_tile(n, 5, kind, ++seed);
        const EvaluatorPlanes planes = leveled(tile);
        glsl::Program program = program_of(planes, static_cast<uint32_t>(seed));
        const auto base = sampler_of(planes.base.texels), values = sampler_of(planes.base.level_values);
        const Painting painting = Painter(tile, static_cast<uint32_t>(seed)).paint(tile_x * n.x, 0, n.x, n.y);
        ASSERT_GE(planes.level_count, 5);
        for (int level = 0; level <= 5; ++level)
          for (int y = 0; y < n.y >> level; ++y)
            for (int x = 0; x < n.x >> level; ++x) {
              const glsl::Texel block{{static_cast<uint32_t>(static_cast<uint64_t>(tile_x)), 0u}, {x, y}};
              const V3f mean = box_mean(painting, tile_x * n.x + (x << level), y << level, 1 << level);
              EXPECT_LE(distance(color_of(program.block_value(base, 0, values, block, program.grid_of(level))), mean),
                        kRounding)
                  << n << " level " << level << " block " << x << " " << y;
            }
      }
}

TEST(Levels, BlocksOfATileThatIsNoPowerOfTwoAreBoxMeansToo) {
  // 96 = 32 · 3: blocks of 32 texels are followed by halves, then the whole; 50 = 2 · 25 has 2, then 1 block of 25, 50.
  for (const V2i& n : {V2i(96, 96), V2i(96, 50)}) {
    const SmallTile tile = random_tile(n, 3, Contents::turned, 68);
    const EvaluatorPlanes planes = leveled(tile);
    glsl::Program program = program_of(planes, 8);
    const auto base = sampler_of(planes.base.texels), values = sampler_of(planes.base.level_values);
    const Painting painting = Painter(tile, 8).paint(0, 0, n.x, n.y);
    for (int level = 1; level <= planes.level_count; ++level) {
      const glsl::Grid grid = program.grid_of(level);
      for (int y = 0; y < grid.blocks.y; ++y)
        for (int x = 0; x < grid.blocks.x; ++x) {
          const V2i side(n.x / grid.blocks.x, n.y / grid.blocks.y);
          Imath::V3d sum(0);
          for (int j = 0; j < side.y; ++j)
            for (int i = 0; i < side.x; ++i) sum += Imath::V3d(painting.color(x * side.x + i, y * side.y + j));
          const glsl::vec4 found = program.block_value(base, 0, values, {{0, 0}, {x, y}}, grid);
          EXPECT_LE(distance(color_of(found), V3f(sum / (double{1} * side.x * side.y))), kRounding) << level;
        }
    }
    EXPECT_EQ(program.grid_of(planes.level_count).blocks.x, 1) << "the last is the tile";
  }
}

TEST(Levels, AWindowWhosePixelsAreBlocksShowsTheirBoxMeans) {
  const SmallTile tile = random_tile({64, 32}, 4, Contents::turned, 60);
  const EvaluatorPlanes planes = leveled(tile);
  for (int level = 0; level <= 5; ++level) {
    Window window;
    window.origin_x = tile_offset(-128, 0, 64);
    window.origin_y = tile_offset(96, 0, 32);
    window.step_256 = 256u << level;
    window.width = 256 >> level;
    window.height = 128 >> level;
    window.seed = 11;
    window.filter = Filter::trilinear;
    const Image<V3f> rows = render_rows(planes, window, 0, window.height);
    const Painting painting = Painter(tile, 11).paint(-128, 96, 256, 128);
    for (int y = 0; y < window.height; ++y)
      for (int x = 0; x < window.width; ++x)
        EXPECT_LE(distance(rows(x, y), box_mean(painting, -128 + (x << level), 96 + (y << level), 1 << level)),
                  kRounding)
            << "level " << level;
  }
}

TEST(Levels, FarAwayRemainsTheMeanOfAllThatMayBeDrawn) {
  const SmallTile tile = random_tile({32, 32}, 3, Contents::moved, 61);
  const EvaluatorPlanes planes = leveled(tile);
  double sum = 0;  // red, over many repetitions
  constexpr int kTiles = 64;
  const Painting painting = Painter(tile, 5).paint(0, 0, 32 * kTiles, 32 * kTiles);
  for (const V3f& c : painting.color) sum += double{c.x};
  const double mean = sum / static_cast<double>(painting.color.size());

  Window window;
  window.step_256 = 256u << 10;  // beyond the last level
  window.width = window.height = 4;
  window.filter = Filter::trilinear;
  const Image<V3f> rows = render_rows(planes, window, 0, 4);
  for (const V3f& c : rows) EXPECT_EQ(c, rows(0, 0));
  // 4096 repetitions of 16 patches, of a standard deviation of 4 / sqrt(12 · 64) each: 5 standard errors.
  EXPECT_NEAR(rows(0, 0).x, mean, 5 * 4 / std::sqrt(12.0 * 64 * 16 * 4096));
}

TEST(Levels, BetweenLevelsIsALerp) {
  const SmallTile tile = random_tile({32, 32}, 3, Contents::moved, 62);
  const EvaluatorPlanes planes = leveled(tile);
  glsl::Program program = program_of(planes, 3);
  const auto base = sampler_of(planes.base.texels), values = sampler_of(planes.base.level_values);
  const glsl::Position at{{4, 5}, {1234, 4321}};
  const glsl::vec4 finer = program.level_value(base, 0, values, at, 2),
                   coarser = program.level_value(base, 0, values, at, 3);
  EXPECT_EQ(program.trilinear_value(base, 0, values, at, 512), finer);
  EXPECT_EQ(program.trilinear_value(base, 0, values, at, 576), program.lerp(finer, coarser, 0.25f));
}

TEST(Levels, WithoutPatchesTheyAreThoseOfThePeriodicTile) {
  const Image<V3f> base = random_base({16, 16}, 63);
  EvaluatorInput input;
  input.base = base;
  EvaluatorPlanes planes = prepare(input);
  glsl::Program program = program_of(planes, 0);
  const glsl::vec4 mean = program.block_value(sampler_of(planes.base.texels), 0, sampler_of(planes.base.level_values),
                                              {{7, 7}, {0, 0}}, program.grid_of(4));
  double sum = 0;
  for (const V3f& c : base) sum += double{c.x};
  EXPECT_NEAR(mean.x, sum / 256, kRounding);
  EXPECT_LE(distance(color_of(mean), color_of(planes.base.level_values(0, 0))), kRounding) << "the mean of all";
}

TEST(Levels, MapsAreAveragedAsTheyAreShownTurnedAndScaled) {
  const V2i n(32, 32);
  const SmallTile tile = random_tile(n, 4, Contents::turned, 64);
  const Image<V3f> noise = random_base(n, 65);
  Image<float> channels[3] = {Image<float>(n.x, n.y), Image<float>(n.x, n.y), Image<float>(n.x, n.y)};
  for (int c = 0; c < 3; ++c)
    for (size_t i = 0; i < noise.size(); ++i) channels[c].data()[i] = noise.data()[i][c] * 0.5f - 1;
  EvaluatorInput input = tile.input();
  input.maps.push_back({"up", MapKind::normal_opengl, {channels[0], channels[1], channels[2]}});
  input.maps.push_back({"down", MapKind::normal_directx, {channels[0], channels[1], channels[2]}});
  input.maps.push_back({"height", MapKind::height, {channels[0]}});
  EvaluatorPlanes planes = prepare(input);
  Window texels;
  texels.width = texels.height = 64;
  texels.filter = Filter::nearest;
  Window blocks = texels;
  blocks.step_256 = 1024;
  blocks.width = blocks.height = 16;
  blocks.filter = Filter::trilinear;
  for (const Plane& map : planes.maps) {
    const Image<V3f> fine = render_map_rows(planes, map, texels, 0, 64);
    const Image<V3f> coarse = render_map_rows(planes, map, blocks, 0, 16);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        V3f sum(0);
        for (int j = 0; j < 4; ++j)
          for (int i = 0; i < 4; ++i) sum += fine(4 * x + i, 4 * y + j);
        EXPECT_LE(distance(coarse(x, y), sum / 16), kRounding) << map.name;
      }
  }
}

TEST(Levels, AFrameAndRowsAgreeAtEveryStep) {
  const SmallTile tile = random_tile({64, 64}, 5, Contents::turned, 66);
  const EvaluatorPlanes planes = leveled(tile);
  for (const uint32_t step_256 : {200u, 256u, 300u, 1000u, 5000u, 100000u}) {
    Window window;
    window.origin_x = tile_offset(-77, 3, 64);
    window.origin_y = tile_offset(1000, 200, 64);
    window.step_256 = step_256;
    window.width = 40;
    window.height = 30;
    window.filter = Filter::trilinear;
    const Frame frame = reference_frame(planes, window, planes.base);
    const Image<V3f> rows = render_rows(planes, window, 0, 30);
    for (size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(color_of(frame.values.data()[i]), rows.data()[i]) << step_256;
  }
}

TEST(Levels, ProbesAreTheMeanOfPointsAlongTheirAxis) {
  const SmallTile tile = random_tile({64, 32}, 5, Contents::moved, 67);
  const EvaluatorPlanes planes = leveled(tile);
  glsl::Program program = program_of(planes, 9);
  const auto base = sampler_of(planes.base.texels), values = sampler_of(planes.base.level_values);
  // Four points across the border of the repetition 2^32 − 1 | 0.
  const glsl::Probes probes{{{0xffffffffu, 0u}, {63 * 256, 40}}, {8192, -4096}, 2, 300};
  double sum = 0;
  for (const int eighth : {-3, -1, 1, 3}) {
    const int64_t x = int64_t{-1} * 64 * 256 + 63 * 256 + 8192 * eighth / 8, y = 40 - 4096 * eighth / 8;
    const TileOffset tx = tile_offset(0, x, 64), ty = tile_offset(0, y, 32);
    const glsl::Position at{{tx.tile, ty.tile}, {static_cast<int>(tx.offset_256), static_cast<int>(ty.offset_256)}};
    sum += double{program.trilinear_value(base, 0, values, at, 300).x};
  }
  EXPECT_NEAR(program.probes_value(base, 0, values, probes).x, sum / 4, kRounding);
}

}  // namespace
}  // namespace texbake
