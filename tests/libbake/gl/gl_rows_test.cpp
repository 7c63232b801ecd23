#include "libbake/gl/gl_rows.h"

#include <gtest/gtest.h>

#include "gl_test_context.h"
#include "libbake/draw/window_rows.h"
#include "tests/libbake/draw/small_tile.h"

namespace texbake {
namespace {

TEST(GlRows, TilesJoinIntoTheRowsOfTheProcessor) {
  const auto context = test_context(ShaderLanguage::glsl_330);
  if (!context) GTEST_SKIP() << "no OpenGL";
  const SmallTile tile = random_tile({48, 32}, 5, Contents::turned, 5);
  const EvaluatorPlanes planes = tile.planes();
  GlRenderer renderer(*context, planes);
  Window window;
  window.origin_x = {0xfffffffeu, 77};
  window.width = 1100;  // two tiles across and two down
  window.height = 1200;
  window.step_256 = 211;
  const Image<V3f> drawn = gl_rows(renderer, planes, planes.base, window, 100, 1180);
  const Image<V3f> expected = render_rows(planes, window, 100, 1180);
  ASSERT_EQ(drawn.height(), expected.height());
  EXPECT_TRUE(drawn == expected);
}

}  // namespace
}  // namespace texbake
