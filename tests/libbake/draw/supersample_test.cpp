#include "libbake/draw/supersample.h"

#include <gtest/gtest.h>

#include "libbake/draw/window_rows.h"
#include "painter.h"

namespace texbake {
namespace {

TEST(Supersample, AsManyNearestSamplesAsTexelsAreTheBoxMean) {
  const SmallTile tile = random_tile({40, 24}, 4, Contents::turned, 80);
  const EvaluatorPlanes planes = tile.planes();
  Window window;
  window.origin_x = tile_offset(-96, 0, 40);
  window.origin_y = tile_offset(33, 0, 24);
  window.step_256 = 3 * 256;
  window.width = 30;
  window.height = 20;
  window.seed = 7;
  window.filter = Filter::nearest;
  const Image<V3f> rows = supersampled_rows(planes, planes.base, window, 3, 5, 20);
  const Painting painting = Painter(tile, 7).paint(-96, 33, 90, 60);
  for (int y = 0; y < 15; ++y)
    for (int x = 0; x < 30; ++x) {
      Imath::V3d sum(0);
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) sum += Imath::V3d(painting.color(3 * x + i, 3 * (y + 5) + j));
      EXPECT_EQ(rows(x, y), V3f(sum / 9.0));
    }
}

TEST(Supersample, OneSampleIsTheWindow) {
  const SmallTile tile = random_tile({32, 32}, 4, Contents::moved, 81);
  const EvaluatorPlanes planes = tile.planes();
  Window window;
  window.origin_x = tile_offset(-5, 100, 32);
  window.step_256 = 300;
  window.width = 50;
  window.height = 40;
  window.filter = Filter::bilinear;
  EXPECT_EQ(supersampled_rows(planes, planes.base, window, 1, 0, 40), render_rows(planes, window, 0, 40));
}

}  // namespace
}  // namespace texbake
