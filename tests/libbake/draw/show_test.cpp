#include "libbake/draw/show.h"

#include <gtest/gtest.h>

#include <set>

#include "libbake/base/error.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "painter.h"

namespace texbake {
namespace {

Window show_window() {
  Window window;
  window.width = window.height = 96;
  return window;
}

std::set<std::tuple<float, float, float>> colors_of(const Image<V3f>& picture) {
  std::set<std::tuple<float, float, float>> colors;
  for (const V3f& c : picture) colors.emplace(c.x, c.y, c.z);
  return colors;
}

TEST(Show, PatchesRepeatWithTheTileWhateverTheSeed) {
  const SmallTile tile = random_tile({32, 32}, 5, Contents::moved, 21);
  const EvaluatorPlanes planes = tile.planes();
  Window window = show_window();
  const Image<V3f> one = show_rows(planes, window, Show::patches, 0, 96);
  window.seed = 99;
  EXPECT_EQ(show_rows(planes, window, Show::patches, 0, 96), one);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(one(x, y), one(x + 32, y + 32));
  EXPECT_EQ(colors_of(one).size(), 1u + static_cast<size_t>(planes.patch_count))
      << "one for each patch, one for borders";
}

TEST(Show, ContentsHaveOneColorEach) {
  const SmallTile tile = random_tile({32, 32}, 5, Contents::moved, 22);
  EXPECT_EQ(colors_of(show_rows(tile.planes(), show_window(), Show::contents, 0, 96)).size(), 1u + 5u);
}

TEST(Show, ColorIsTheRendering) {
  const SmallTile tile = random_tile({32, 32}, 5, Contents::moved, 23);
  const EvaluatorPlanes planes = tile.planes();
  EXPECT_EQ(show_rows(planes, show_window(), Show::color, 0, 96), render_rows(planes, show_window(), 0, 96));
}

TEST(Show, WhatTheTileLacksIsRefusedWithTheVerbThatMakesIt) {
  const SmallTile tile = random_tile({32, 32}, 5, Contents::moved, 24);
  for (const Show show : {Show::fragments, Show::index, Show::variation, Show::noise, Show::masks})
    EXPECT_THROW(check_show(tile.input(), show), Error) << enum_name(show);
  EXPECT_NO_THROW(check_show(tile.input(), Show::patches));
}

TEST(Show, IndexAndVariationComeFromTheContentsSource) {
  SmallTile tile = random_tile({32, 32}, 5, Contents::moved, 25);
  PrincipalVariation colors;
  colors.palette.classes = {{V3f(50, 0, 0), V3f(1, 0, 0)}, {V3f(80, 0, 0), V3f(1, 0, 0)}};
  colors.index = Image<uint8_t>(32, 32);
  colors.variation = Image<float>(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) colors.index(x, y) = tile.base(x, y).x > 2.0f;
  EvaluatorInput input = tile.input();
  input.colors = &colors;
  const EvaluatorPlanes planes = prepare(input);
  const Image<V3f> index = show_rows(planes, show_window(), Show::index, 0, 96);
  const Painting painting = Painter(tile, 0).paint(0, 0, 96, 96);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) EXPECT_EQ(index(x, y).y > 0.4f, painting.color(x, y).x > 2.0f);
  EXPECT_EQ(show_rows(planes, show_window(), Show::variation, 0, 1)(3, 0), V3f(0.5f)) << "v = 0 is middle grey";
}

}  // namespace
}  // namespace texbake
