// The noise layer of shaders/noise.glsl on the processor.
#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/draw/compare.h"
#include "libbake/draw/frame.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/program_of.h"
#include "tests/libbake/draw/painter.h"

namespace texbake {
namespace {

Window texel_window(V2i tile_size, int64_t x0, int64_t y0, int side, uint32_t seed) {
  Window window;
  window.origin_x = tile_offset(x0, 0, tile_size.x);
  window.origin_y = tile_offset(y0, 0, tile_size.y);
  window.width = window.height = side;
  window.seed = seed;
  return window;
}

Image<V3f> render(const EvaluatorPlanes& planes, const Window& window) {
  return render_rows(planes, window, 0, window.height);
}

TEST(NoiseLayer, TheForwardPainterEqualsTheEvaluatorWithOneToFourNoises) {
  uint64_t seed = 40;
  for (const NoiseSpace space : {NoiseSpace::root, NoiseSpace::linear})
    for (int count = 1; count <= 4; ++count)
      for (const int64_t repetition : {int64_t{0}, int64_t{-3}, int64_t{1} << 31, -(int64_t{1} << 31)}) {
        SmallTile tile = random_tile({40, 24}, 5, count % 2 == 0 ? Contents::turned : Contents::moved, ++seed);
        add_noise(tile, count, 16, seed, space);
        const int64_t x0 = repetition * 40 - 50, y0 = repetition * 24 - 41;
        const Painting painting = Painter(tile, 9).paint(x0, y0, 96, 96);
        EXPECT_EQ(render(tile.planes(), texel_window({40, 24}, x0, y0, 96, 9)), painting.color)
            << count << " noises, repetition " << repetition;
      }
}

TEST(NoiseLayer, RowsEqualTheReferenceTextPointByPoint) {
  SmallTile tile = random_tile({33, 47}, 5, Contents::turned, 50);
  add_noise(tile, 3, 32, 50);
  const EvaluatorPlanes planes = tile.planes();
  for (const uint32_t step : {77u, 256u, 700u}) {
    Window window = texel_window({33, 47}, -1000, 12345, 64, 3);
    window.step_256 = step;
    const Frame frame = reference_frame(planes, window, planes.base);
    EXPECT_EQ(render(planes, window), color_values(frame.values)) << step;
  }
}

TEST(NoiseLayer, ZeroNoiseIsTheStructureAlone) {
  SmallTile tile = random_tile({40, 24}, 5, Contents::turned, 51);
  const Image<V3f> structure = render(tile.planes(), texel_window({40, 24}, -77, 5, 96, 1));
  add_noise(tile, 3, 16, 51);
  for (Image<V3f>& noise : tile.noises)
    for (V3f& color : noise) color = V3f(0);
  EXPECT_EQ(render(tile.planes(), texel_window({40, 24}, -77, 5, 96, 1)), structure);
}

TEST(NoiseLayer, TheRootIsExactToTwentyParts) {
  // What two steps of Newton's method leave of an error of 3.5 %: 1.5 · (1.5 · 0.035²)² = 5e-6.
  glsl::Program program;
  EXPECT_EQ(program.twice_root(0.0f), 0.0f);
  EXPECT_EQ(program.twice_root(-1.0f), 0.0f);
  for (float x = 0x1p-24f; x < 65504.0f; x *= 1.0017f)
    EXPECT_NEAR(program.twice_root(x) / (2 * std::sqrt(x)), 1.0f, 5.1e-6f) << x;
}

TEST(NoiseLayer, InTheRootItIsASquareAndNeverBelowBlack) {
  SmallTile tile = random_tile({40, 24}, 5, Contents::moved, 55);
  for (V3f& color : tile.base) color *= 0.125f;  // darker than the noise is strong
  add_noise(tile, 1, 16, 55);
  const Window window = texel_window({40, 24}, 5, 7, 96, 2);
  const Image<V3f> seen = render(tile.planes(), window);
  const Painting structure = Painter(tile, 2).paint(5, 7, 96, 96);
  const Painter painter(tile, 2);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      for (int c = 0; c < 3; ++c) {
        const float n = tile.noises[0].data()[painter.noise_number(tile.noises[0], x + 5, y + 7)][c];
        const float root = std::sqrt(structure.structure(x, y)[c]) + n;
        EXPECT_NEAR(seen(x, y)[c], root * root, 1e-5f);  // 5e-6 of a product below 1
      }
}

TEST(NoiseLayer, ItDoesNotFollowContentsAndIsSeamlessWhereCoordinatesWrap) {
  // One noise on a constant structure: what is seen is the noise, at every content and repetition.
  SmallTile tile = random_tile({40, 24}, 5, Contents::turned, 52);
  for (V3f& color : tile.base) color = V3f(0.5f);
  add_noise(tile, 1, 16, 52, NoiseSpace::linear);
  constexpr int64_t kWrap = int64_t{1} << 32;
  for (const int64_t x0 : {int64_t{0}, int64_t{-48}, kWrap - 48, kWrap * 40 - 48})
    for (const int64_t y0 : {int64_t{-16}, kWrap - 16}) {
      const Image<V3f> seen = render(tile.planes(), texel_window({40, 24}, x0, y0, 96, 4));
      for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
          // 161 further in each row, and x0 = -48, y0 = -16 but for multiples of the 256 values.
          const int n = (x + (x0 == 0 ? 0 : 256 - 48) + 161 * (y + 240)) % 256;
          EXPECT_EQ(seen(x, y), V3f(0.5f) + tile.noises[0].data()[n]);
        }
    }
}

TEST(NoiseLayer, WeightsSumToOneUnderEveryTurn) {
  SmallTile tile = random_tile({40, 24}, 5, Contents::turned, 53);
  add_noise(tile, 4, 16, 53);
  const EvaluatorPlanes planes = tile.planes();
  glsl::Program program = program_of(planes, 7u);
  int blended = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 400; ++x) {
      const glsl::Texel at{{static_cast<uint32_t>(x / 40), static_cast<uint32_t>(y / 24)}, {x % 40, y % 24}};
      const glsl::Source source = program.texel_source(at);
      const glsl::uvec4 weights = program.source_weights(source);
      EXPECT_EQ(weights.x + weights.y + weights.z + weights.w, 2048u);
      EXPECT_LE(weights.x, 2048u);
      if (source.fraction.x != 0) ++blended;
    }
  EXPECT_GT(blended, 1000);
}

TEST(NoiseLayer, WhatDoesNotFitIsRefused) {
  SmallTile good = random_tile({40, 24}, 5, Contents::moved, 54);
  add_noise(good, 2, 16, 54);
  const auto refused = [&](const auto& spoil) {
    SmallTile tile{good.base.clone(), {unwrap(good.patches.partition.idx.clone())}, good.contents};
    add_noise(tile, 2, 16, 54);
    spoil(tile);
    EXPECT_THROW(tile.planes(), Error);
  };
  refused([](SmallTile& tile) { tile.noises.pop_back(); });
  refused([](SmallTile& tile) { tile.masks[0](3, 3) += 1.0f / 4096; });
  refused([](SmallTile& tile) { tile.masks[0](3, 3) = -1.0f / 2048; });
  refused([](SmallTile& tile) { tile.masks[1](3, 3) += 1.0f / 2048; });
  refused([](SmallTile& tile) { tile.noises[0] = Image<V3f>(24, 24); });
  refused([](SmallTile& tile) { tile.noises[1] = Image<V3f>(32, 16); });
  refused([](SmallTile& tile) { tile.noise_step = 160; });
  refused([](SmallTile& tile) { tile.noise_step = 0; });
  refused([](SmallTile& tile) { tile.masks[0] = Image<float>(24, 40); });
}

}  // namespace
}  // namespace texbake
