#include "libbake/report/reduced_tile.h"

#include <gtest/gtest.h>

#include "libbake/base/half.h"
#include "libbake/base/random.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "tests/libbake/report/tile_fixture.h"

namespace texbake {
namespace {

TEST(ReducedTile, TakesTheLeastFactorThatDividesBothSides) {
  EXPECT_EQ(reduction_to({1024, 1024}, 1024), 1);
  EXPECT_EQ(reduction_to({1024, 512}, 256), 4);
  EXPECT_EQ(reduction_to({960, 960}, 256), 4);
  EXPECT_EQ(reduction_to({1023, 1024}, 256), 1);  // coprime sides stay as they are
}

TEST(ReducedTile, DrawsTheMeansOfWhatTheWholeTileDraws) {
  // Patches and translations lie on the grid of blocks, so that reducing before and after drawing is the same.
  TileFixture fixture = tile_fixture(64, 3);
  for (Content& content : fixture.contents.contents) content.translation = content.translation / 4 * 4;
  const ReducedTile reduced = reduced_tile(fixture.input(), 4);
  const EvaluatorPlanes small = prepare(reduced.input());
  const EvaluatorPlanes large = prepare(fixture.input());
  Window window;
  window.filter = Filter::nearest;
  window.seed = 5;
  window.width = window.height = 2 * 16;
  const Image<V3f> found = render_rows(small, window, 0, window.height);
  window.width = window.height = 2 * 64;
  const Image<V3f> whole = render_rows(large, window, 0, window.height);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      V3f mean(0);
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) mean += whole(4 * x + i, 4 * y + j) / 16.0f;
      EXPECT_NEAR(found(x, y).x, mean.x, 1e-6f);  // sums in another order
    }
}

TEST(ReducedTile, KeepsNoisesPowersOfTwo) {
  TileFixture fixture = tile_fixture(96, 2);
  const Image<float> mask(96, 96, 1.0f);
  Image<V3f> noise(64, 64);
  Random random(3, 0);
  for (V3f& value : noise) value = half_exact(V3f(random.uniform()));
  EvaluatorInput input = fixture.input();
  EXPECT_EQ(reduction_to(input, 32), 3);
  input.noise = NoiseInput{{mask}, {noise}, 1201};
  EXPECT_EQ(reduction_to(input, 32), 4);
  const ReducedTile reduced = reduced_tile(input, 4);
  ASSERT_EQ(reduced.noise_tiles.size(), 1u);
  ASSERT_EQ(reduced.noise_tiles[0].size(), 64u * 64 / 4) << "a quarter of the blocks of 4 x 4 texels, in a row";
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) {
      double sum = 0;
      for (int j = 4 * y; j < 4 * y + 4; ++j)
        for (int i = 4 * x; i < 4 * x + 4; ++i) sum += double{noise.data()[(i + 1201 * j) % 4096].x};
      EXPECT_EQ(reduced.noise_tiles[0].data()[(x + 1201 * y) % 1024].x, half_exact(static_cast<float>(sum / 16)));
    }
  EXPECT_EQ(reduced.masks[0].width(), 24);
  EXPECT_NO_THROW(prepare(reduced.input()));
}

}  // namespace
}  // namespace texbake
