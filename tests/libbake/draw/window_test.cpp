#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "painter.h"

namespace texbake {
namespace {

/// Texels of a window: step 1, pixels are texels.
Window texel_window(V2i tile_size, int64_t x0, int64_t y0, int width, int height, uint32_t seed) {
  Window window;
  window.origin_x = tile_offset(x0, 0, tile_size.x);
  window.origin_y = tile_offset(y0, 0, tile_size.y);
  window.width = width;
  window.height = height;
  window.seed = seed;
  return window;
}

Image<V3f> render(const EvaluatorPlanes& planes, const Window& window) {
  return render_rows(planes, window, 0, window.height);
}

struct Case {
  V2i size;
  Contents kind;
  int64_t x0, y0;
};

/// Non-square and odd tiles; the origin, negative coordinates, and the places where tile coordinates reach 2^31, 2^32.
std::vector<Case> cases() {
  const V2i sizes[] = {{32, 32}, {40, 24}, {33, 47}};
  std::vector<Case> all;
  for (const V2i& n : sizes)
    for (const Contents kind : {Contents::moved, Contents::turned})
      for (const int64_t tile : {int64_t{0}, int64_t{-3}, int64_t{1} << 31, int64_t{1} << 32, -(int64_t{1} << 31)})
        all.push_back({n, kind, tile * n.x - 50, tile * n.y - 41});
  return all;
}

TEST(Window, TheForwardPainterPaintsEveryTexelOnceAndEqualsTheEvaluator) {
  uint64_t seed = 1;
  for (const Case& c : cases()) {
    const SmallTile tile = random_tile(c.size, 5, c.kind, ++seed);
    const Painting painting = Painter(tile, static_cast<uint32_t>(seed)).paint(c.x0, c.y0, 110, 97);
    EXPECT_EQ(painting.times, Image<int>(110, 97, 1));
    Window window = texel_window(c.size, c.x0, c.y0, 110, 97, static_cast<uint32_t>(seed));
    window.filter = Filter::nearest;
    EXPECT_EQ(render(tile.planes(), window), painting.color) << c.size << " " << c.x0;
    window.filter = Filter::bilinear;
    EXPECT_EQ(render(tile.planes(), window), painting.color) << c.size << " " << c.x0;
  }
}

/// The window by definition, from painted texels: pixel (i, j) shows the point origin + (i + ½, j + ½) · step.
Image<V3f> slow_window(const Painting& texels, int64_t x0_256, int64_t y0_256, const Window& window) {
  const auto point = [&](int64_t origin, int i) { return origin + int64_t{i} * window.step_256 + window.step_256 / 2; };
  const auto at = [&](int64_t x, int64_t y) {
    return texels.color(static_cast<int>(x - texels.x0), static_cast<int>(y - texels.y0));
  };
  Image<V3f> out(window.width, window.height);
  for (int j = 0; j < window.height; ++j)
    for (int i = 0; i < window.width; ++i) {
      const int64_t x = point(x0_256, i), y = point(y0_256, j);
      if (window.filter == Filter::nearest) {
        out(i, j) = at(x >> 8, y >> 8);
        continue;
      }
      const int64_t left = (x - 128) >> 8, top = (y - 128) >> 8;
      const double wx = static_cast<double>(x - 128 - left * 256) / 256;
      const double wy = static_cast<double>(y - 128 - top * 256) / 256;
      out(i, j) = Painter::blend(at(left, top), at(left + 1, top), at(left, top + 1), at(left + 1, top + 1), wx, wy);
    }
  return out;
}

TEST(Window, AnyStepAndFractionIsTheFilterOfThePaintedTexels) {
  const V2i n(40, 24);
  for (const Contents kind : {Contents::moved, Contents::turned})
    for (const uint32_t step_256 : {1u, 37u, 128u, 256u, 300u, 777u})
      for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
        const SmallTile tile = random_tile(n, 4, kind, step_256);
        const int64_t x0 = (int64_t{1} << 32) * n.x - 31, y0 = -17;
        Window window = texel_window(n, x0, y0, 60, 53, 9);
        window.step_256 = step_256;
        window.filter = filter;
        window.origin_x = tile_offset(x0, 77, n.x);
        window.origin_y = tile_offset(y0, 201, n.y);
        const int texels = static_cast<int>(60 * step_256 / 256) + 5;
        const Painting painting = Painter(tile, 9).paint(x0 - 2, y0 - 2, texels, texels);
        EXPECT_EQ(render(tile.planes(), window), slow_window(painting, x0 * 256 + 77, y0 * 256 + 201, window))
            << "step " << step_256 << " " << enum_name(filter);
      }
}

TEST(Window, CutsIntoRowsDoNotShow) {
  const SmallTile tile = random_tile({32, 40}, 5, Contents::turned, 3);
  const EvaluatorPlanes planes = tile.planes();
  Window window = texel_window(tile.size(), -1000, 77, 70, 130, 5);
  window.step_256 = 200;
  const Image<V3f> whole = render(planes, window);
  for (const int cut : {1, 31, 32, 33, 129}) {
    const Image<V3f> upper = render_rows(planes, window, 0, cut), lower = render_rows(planes, window, cut, 130);
    EXPECT_TRUE(std::equal(upper.begin(), upper.end(), whole.begin()));
    EXPECT_TRUE(std::equal(lower.begin(), lower.end(), whole.row(cut)));
  }
}

TEST(Window, OneContentGivesTheTiledBase) {
  SmallTile tile = random_tile({32, 24}, 1, Contents::moved, 4);
  const Window window = texel_window(tile.size(), -7, 5, 100, 90, 123);
  Image<V3f> tiled(100, 90);
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 100; ++x) tiled(x, y) = tile.base(wrap(x - 7, 32), wrap(y + 5, 24));
  EXPECT_EQ(render(tile.planes(), window), tiled);

  EvaluatorInput bare;
  bare.base = tile.base;
  EXPECT_EQ(render(prepare(bare), window), tiled) << "without patches";
  bare.patches = &tile.patches;
  EXPECT_EQ(render(prepare(bare), window), tiled) << "without contents";
}

TEST(Window, AConstantStaysConstant) {
  SmallTile tile = random_tile({32, 32}, 5, Contents::turned, 5);
  const V3f constant(0.3f, 1.7f, 0.001f);
  tile.base = Image<V3f>(32, 32, constant);
  Window window = texel_window(tile.size(), 1000, -1000, 80, 80, 1);
  window.step_256 = 93;
  EXPECT_EQ(render(tile.planes(), window), Image<V3f>(80, 80, constant));
}

TEST(Window, WholeTexelsShowTheNearestExactly) {
  const SmallTile tile = random_tile({48, 32}, 5, Contents::turned, 6);
  Window window = texel_window(tile.size(), 123456789, -987654321, 120, 100, 1);
  const Image<V3f> bilinear = render(tile.planes(), window);
  window.filter = Filter::nearest;
  EXPECT_EQ(render(tile.planes(), window), bilinear);
}

TEST(Window, AnEmptyOrEndlessWindowIsRefused) {
  const V2i n(32, 32);
  EXPECT_THROW(check_window(texel_window(n, 0, 0, 0, 5, 0), n), Error);
  Window window = texel_window(n, 0, 0, 1 << 24, 5, 0);
  EXPECT_THROW(check_window(window, n), Error);
  window.width = (1 << 24) - 33;
  EXPECT_NO_THROW(check_window(window, n));
  window.step_256 = 0;
  EXPECT_THROW(check_window(window, n), Error);
  window = texel_window(n, 0, 0, 5, 5, 0);
  window.origin_y.offset_256 = 32 * 256;
  EXPECT_THROW(check_window(window, n), Error);
}

}  // namespace
}  // namespace texbake
