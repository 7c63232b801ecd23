#include "libbake/planes/noise_levels.h"

#include <gtest/gtest.h>

#include "libbake/planes/levels.h"
#include "libbake/planes/program_of.h"
#include "tests/libbake/draw/level_painter.h"
#include "tests/libbake/planes/level_bias.h"

namespace texbake {
namespace {

V3f color_of(const glsl::vec4& v) { return {v.x, v.y, v.z}; }

double distance(const V3f& a, const V3f& b) {
  const V3f d = a - b;
  return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

/// Noises of −0.5 … 0.5, rounded to half once more as means: half a step of 2^-12, and float sums of values up to 5.
constexpr double kRounding = 0x1p-12 + 1e-5;

EvaluatorPlanes leveled(const SmallTile& tile) {
  EvaluatorPlanes planes = tile.planes();
  return planes;
}

TEST(NoiseLevels, AreTheBoxMeansOfTheNoiseWithoutItsMean) {
  SmallTile tile = random_tile({32, 32}, 2, Contents::moved, 70);
  add_noise(tile, 3, 16, 70, NoiseSpace::linear);
  const EvaluatorPlanes planes = tile.planes();
  glsl::Program program = program_of(planes, 0u);
  for (int k = 0; k < 3; ++k) {
    const Image<V3f>& noise = tile.noises[static_cast<size_t>(k)];
    Imath::V3d mean(0);
    for (const V3f& c : noise) mean += Imath::V3d(c) / 256.0;
    for (int level = 1; level <= 4; ++level)
      for (int y = 0; y < 32 >> level; ++y)
        for (int x = 0; x < 32 >> level; ++x) {
          Imath::V3d sum(0);
          const int side = 1 << level;
          for (int j = y * side; j < (y + 1) * side; ++j)
            for (int i = x * side; i < (x + 1) * side; ++i)
              sum += Imath::V3d(noise.data()[(i + tile.noise_step * j) % 256]);
          const glsl::Texel at{{0, 0}, {x * side + side / 2, y * side + side / 2}};
          const V3f found = color_of(program.noise_value(k, program.noise_level_place(at, level)));
          EXPECT_EQ(found, half_exact(V3f(sum / side / side - mean))) << k << " level " << level;
        }
  }
}

TEST(NoiseLevels, ABlockUnderOneNoiseIsTheBoxMeanOfThePaintedTexture) {
  // Blocks as large as the noise are the last that have more than its mean.
  for (const NoiseSpace space : {NoiseSpace::root, NoiseSpace::linear})
    for (const int noise_size : {16, 64}) {
      const int64_t tile_x = noise_size == 16 ? -2 : int64_t{1} << 32;
      SmallTile tile = random_tile({64, 32}, 4, Contents::turned, 71);
      if (space == NoiseSpace::root)  // a block has one root for its texels
        for (V3f& color : tile.base) color = V3f(0.25f, 1, 2);
      add_noise(tile, 1, noise_size, 71, space);
      const EvaluatorPlanes planes = leveled(tile);
      glsl::Program program = program_of(planes, 7u);
      const Painting painting = Painter(tile, 7).paint(tile_x * 64, 0, 64, 32);
      for (int level = 1; level <= (noise_size == 16 ? 4 : 5); ++level)
        for (int y = 0; y < 32 >> level; ++y)
          for (int x = 0; x < 64 >> level; ++x) {
            Imath::V3d sum(0);
            const int side = 1 << level;
            for (int j = 0; j < side; ++j)
              for (int i = 0; i < side; ++i) sum += Imath::V3d(painting.color(x * side + i, y * side + j));
            const glsl::Texel block{{static_cast<uint32_t>(static_cast<uint64_t>(tile_x)), 0u}, {x, y}};
            const glsl::vec4 found = program.block_value(
                sampler_of(planes.base.texels), 4, sampler_of(planes.base.level_values), block, program.grid_of(level));
            // In the root what is rounded is multiplied by 2 √2 at most, and its square comes to it.
            const double rounding = space == NoiseSpace::root ? 4 * kRounding : kRounding;
            EXPECT_LE(distance(color_of(found), V3f(sum / side / side)), rounding) << level;
          }
    }
}

TEST(NoiseLevels, BlocksEqualTheSlowPainterBitByBit) {
  for (const NoiseSpace space : {NoiseSpace::root, NoiseSpace::linear}) {
    SmallTile tile = random_tile({32, 16}, 3, Contents::turned, 72);
    add_noise(tile, 3, 32, 72, space);
    const EvaluatorPlanes planes = leveled(tile);
    glsl::Program program = program_of(planes, 5u);
    const LevelPainter painter(tile, 5);
    for (int level = 1; level <= 4; ++level)
      for (int y = 0; y < 16 >> level; ++y)
        for (int x = 0; x < 32 >> level; ++x)
          EXPECT_EQ(
              color_of(program.block_value(sampler_of(planes.base.texels), 4, sampler_of(planes.base.level_values),
                                           {{0, 0}, {x, y}}, program.grid_of(level))),
              painter.block(x, y, level))
              << level;
  }
}

TEST(NoiseLevels, AreWithoutBiasWhateverTheMasks) {
  // White noise and masks as fine as texels: the worst that there is. What differs in a block differs both ways.
  for (const NoiseSpace space : {NoiseSpace::root, NoiseSpace::linear}) {
    SmallTile tile = random_tile({64, 64}, 3, Contents::turned, 73);
    for (V3f& color : tile.base) color = half_exact(color * 0.0625f);  // up to 1/4, whose root doubled is 1
    add_noise(tile, 3, 64, 73, space);
    const EvaluatorPlanes planes = leveled(tile);
    for (const LevelBias& bias : level_biases(planes, planes.base, 1, 3))
      EXPECT_LE(std::abs(bias.unbiased.signed_mean), 0.5 / 255) << bias.level;
  }
}

TEST(NoiseLevels, BlocksOfOtherSidesTakeTheLevelNearestInSize) {
  // 96 = 32 · 3 has blocks of 32, 48 and 96 texels; 50 = 2 · 25 of 2, 25 and 50.
  SmallTile tile = random_tile({96, 50}, 2, Contents::moved, 74);
  add_noise(tile, 2, 32, 74);
  const EvaluatorPlanes planes = leveled(tile);
  glsl::Program program = program_of(planes, 1u);
  for (int level = 0; level <= planes.level_count; ++level) {
    const glsl::Grid grid = program.grid_of(level);
    const double texels = double{1} * 96 / grid.blocks.x * 50 / grid.blocks.y;
    if (grid.noise < 0) {
      EXPECT_GE(texels, 2 * 32 * 32) << "more than the whole noise twice";
      continue;
    }
    const double noise_texels = std::pow(4.0, grid.noise);
    EXPECT_LE(texels / noise_texels, 2.0) << level;
    EXPECT_GE(texels / noise_texels, 0.5) << level;
  }
}

}  // namespace
}  // namespace texbake
