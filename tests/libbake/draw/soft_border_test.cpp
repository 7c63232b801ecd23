// Soft borders of patches: weights, variance, and levels of detail on top of them.
#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/draw/frame.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/soft_cover.h"
#include "small_tile.h"

namespace texbake {
namespace {

EvaluatorPlanes softened(const SmallTile& tile, int soft_border_px) {
  EvaluatorInput input = tile.input();
  input.soft_border_px = soft_border_px;
  return prepare(input);
}

Window texels(int width, int height) {
  Window window;
  window.origin_x = {7, 50 * 256};
  window.origin_y = {0xffffffffu, 20 * 256};
  window.width = width;
  window.height = height;
  window.seed = 3;
  window.filter = Filter::nearest;
  return window;
}

TEST(SoftBorder, WeightsOfATexelSumToOneAndItsOwnPatchIsFirst) {
  const EvaluatorPlanes planes = random_tile({64, 48}, 3, Contents::moved, 100).planes();
  const SoftCover soft = soft_cover(planes.patch_plane, 4);
  ASSERT_EQ(soft.weights.size(), soft.cover.entries.size());
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto entries = soft.cover.at(x, y);
      EXPECT_EQ(entries[0], planes.patch_plane(x, y));
      float sum = 0;
      for (size_t i = 0; i < entries.size(); ++i) sum += soft.weights[soft.cover.first_at(x, y) + i];
      EXPECT_NEAR(sum, 1, 1e-6);
    }
}

TEST(SoftBorder, AcrossAStraightBorderWeightsChangeEvenly) {
  // Two patches side by side; of a tent of 2 w − 1 = 3 texels (1 2 1) / 4, texels beside the border see a quarter of
  // the other.
  Image<glsl::PatchTexel> plane(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) plane(x, y) = {static_cast<uint16_t>(x / 16), 5};
  const SoftCover soft = soft_cover(plane, 2);
  EXPECT_EQ(soft.weights[soft.cover.first_at(15, 9)], 0.75f);
  EXPECT_EQ(soft.weights[soft.cover.first_at(15, 9) + 1], 0.25f);
  EXPECT_EQ(soft.cover.at(14, 9).size(), 1u);
  // Beyond the border of the tile the same patch is another: its center lies a repetition away.
  EXPECT_EQ(soft.cover.at(31, 9)[1], (glsl::PatchTexel{0, 6}));
  EXPECT_EQ(soft.cover.at(0, 9)[1], (glsl::PatchTexel{1, 4}));
}

TEST(SoftBorder, OfOneTexelIsHard) {
  const SmallTile tile = random_tile({64, 64}, 5, Contents::turned, 101);
  const Window window = texels(150, 150);
  EXPECT_EQ(render_rows(softened(tile, 1), window, 0, 150), render_rows(tile.planes(), window, 0, 150));
}

TEST(SoftBorder, OneContentGivesTheTiledBaseAndAConstantStays) {
  SmallTile tile = random_tile({64, 64}, 1, Contents::moved, 102);
  const Window window = texels(100, 100);
  const Image<V3f> soft = render_rows(softened(tile, 4), window, 0, 100);
  const Image<V3f> hard = render_rows(tile.planes(), window, 0, 100);
  for (size_t i = 0; i < soft.size(); ++i) EXPECT_LE((soft.data()[i] - hard.data()[i]).length(), 1e-5);

  tile = random_tile({64, 64}, 5, Contents::turned, 103);
  for (V3f& c : tile.base) c = V3f(0.25f, 0.5f, 1);
  for (const V3f& c : render_rows(softened(tile, 4), window, 0, 100))
    EXPECT_LE((c - V3f(0.25f, 0.5f, 1)).length(), 1e-5);
}

TEST(SoftBorder, VarianceIsKept) {
  const SmallTile tile = random_tile({128, 128}, 5, Contents::moved, 104);
  const EvaluatorPlanes planes = softened(tile, 4);
  const SoftCover soft = soft_cover(planes.patch_plane, 4);
  // Noise of variance 4² / 12, apart by the strongest weight: interior texels, and those on borders.
  double sum[2] = {0, 0}, squares[2] = {0, 0}, count[2] = {0, 0};
  Window window = texels(128, 128);
  window.origin_x.offset_256 = window.origin_y.offset_256 = 0;
  for (uint32_t seed = 0; seed < 20; ++seed) {
    window.seed = seed;
    const Image<V3f> rows = render_rows(planes, window, 0, 128);
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {
        const float weight = soft.weights[soft.cover.first_at(x, y)];
        if (weight > 0.65f && weight < 1) continue;
        const int on_border = weight < 1;
        sum[on_border] += double{rows(x, y).x};
        squares[on_border] += double{rows(x, y).x} * double{rows(x, y).x};
        ++count[on_border];
      }
  }
  const auto variance = [&](int i) { return squares[i] / count[i] - sum[i] / count[i] * sum[i] / count[i]; };
  ASSERT_GT(count[1], 10000);
  // The local mean's own share of white noise, 1 / (4 π 8²), is the only one that is blended plainly.
  EXPECT_NEAR(variance(1) / variance(0), 1, 0.05) << "a plain blend keeps about half";
}

TEST(SoftBorder, LevelsAreBoxMeansOfTheSoftTexture) {
  const SmallTile tile = random_tile({64, 64}, 5, Contents::turned, 105);
  const EvaluatorPlanes planes = softened(tile, 3);
  Window window = texels(128, 64);
  window.origin_x.offset_256 = window.origin_y.offset_256 = 0;
  Image<V3f> means = render_rows(planes, window, 0, 64);
  for (int level = 1; level <= 6; ++level) {
    Image<V3f> halves(means.width() / 2, means.height() / 2);
    for (int y = 0; y < halves.height(); ++y)
      for (int x = 0; x < halves.width(); ++x)
        halves(x, y) =
            (means(2 * x, 2 * y) + means(2 * x + 1, 2 * y) + means(2 * x, 2 * y + 1) + means(2 * x + 1, 2 * y + 1)) / 4;
    means = std::move(halves);
    Window blocks = window;
    blocks.filter = Filter::trilinear;
    blocks.step_256 = 256u << level;
    blocks.width = means.width();
    blocks.height = means.height();
    const Image<V3f> rows = render_rows(planes, blocks, 0, blocks.height);
    for (size_t i = 0; i < rows.size(); ++i) EXPECT_LE((rows.data()[i] - means.data()[i]).length(), 1e-5) << level;
  }
}

TEST(SoftBorder, TooWideForTheTileIsRefused) {
  const SmallTile tile = random_tile({64, 48}, 2, Contents::moved, 106);
  EXPECT_NO_THROW(softened(tile, 6));
  EXPECT_THROW(softened(tile, 7), Error);
  EXPECT_THROW(softened(tile, -1), Error);
}

}  // namespace
}  // namespace texbake
