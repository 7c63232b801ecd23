#include "libbake/report/rendering.h"

#include <algorithm>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"
#include "libbake/draw/frame.h"
#include "libbake/draw/window_rows.h"
#include "libbake/quality/baselines.h"

namespace texbake {
namespace {

constexpr int kStripRows = 128;

Window whole_tiles(V2i tile, V2i tiles, uint32_t seed) {
  Window window;
  window.width = tile.x * tiles.x;
  window.height = tile.y * tiles.y;
  window.seed = seed;
  window.filter = Filter::nearest;
  return window;
}

// Draws the rows begin … end−1 by `rows_of(begin, end)`, linear, into a picture in CIELUV. What noise takes below black
// is black, as on a screen: CIELUV has no such colors, and their u, v have no bounds.
template <class RowsOf>
Image<V3f> luv_by_strips(V2i size, const RowsOf& rows_of) {
  Image<V3f> picture(size.x, size.y);
  for (int begin = 0; begin < size.y; begin += kStripRows) {
    Image<V3f> rows = rows_of(begin, std::min(begin + kStripRows, size.y));
    for (V3f& c : rows) c = {std::max(c.x, 0.0f), std::max(c.y, 0.0f), std::max(c.z, 0.0f)};
    const Image<V3f> luv = luv_from_linear(rows);
    std::copy(luv.begin(), luv.end(), picture.row(begin));
  }
  return picture;
}

// A picture whose texel (x, y) is `value(x, y)`.
template <class T, class ValueAt>
Image<T> picture_of(V2i size, const ValueAt& value) {
  Image<T> picture(size.x, size.y);
  parallel_for(0, size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) picture(x, y) = value(x, y);
  });
  return picture;
}

}  // namespace

Image<V3f> bundle_luv(const EvaluatorPlanes& planes, V2i tiles, uint32_t seed) {
  const Window window = whole_tiles(planes.size, tiles, seed);
  return luv_by_strips({window.width, window.height},
                       [&](int begin, int end) { return render_rows(planes, window, begin, end); });
}

Image<V3f> periodic_luv(ImageView<const V3f> tile_luv, V2i tiles) {
  return periodic_baseline(tile_luv, tile_luv.width() * tiles.x, tile_luv.height() * tiles.y);
}

Image<V3f> wang_luv(ImageView<const V3f> tile_luv, V2i tiles, uint32_t seed) {
  const WangTiling tiling(tile_luv, tiles, seed);
  return picture_of<V3f>(tiling.size_px(), [&](int x, int y) {
    const V2i source = tiling.source(x, y);
    return tile_luv(source.x, source.y);
  });
}

Image<V3f> hex_luv(ImageView<const V3f> tile_linear, V2i tiles, uint32_t seed) {
  const V2i size(tile_linear.width() * tiles.x, tile_linear.height() * tiles.y);
  return luv_by_strips(size,
                       [&](int begin, int end) { return hex_baseline_rows(tile_linear, size.x, begin, end, seed); });
}

RenderingSources bundle_sources(const EvaluatorPlanes& planes, V2i tiles, uint32_t seed) {
  const Frame frame = reference_frame(planes, whole_tiles(planes.size, tiles, seed), planes.base);
  const V2i size(frame.decisions.width(), frame.decisions.height());
  return {picture_of<V2i>(size,
                          [&](int x, int y) {
                            const PixelDecision& decision = frame.decisions(x, y);
                            return V2i(static_cast<int>(decision.source_x), static_cast<int>(decision.source_y));
                          }),
          picture_of<uint32_t>(size, [&](int x, int y) { return frame.decisions(x, y).patch_idx; }),
          planes.soft_border_px > 0 || planes.noise_step != 0 ? bundle_luv(planes, tiles, seed) : Image<V3f>()};
}

RenderingSources periodic_sources(V2i tile, V2i tiles) {
  const V2i size(tile.x * tiles.x, tile.y * tiles.y);
  return {picture_of<V2i>(size, [&](int x, int y) { return V2i(x % tile.x, y % tile.y); }), {}, {}};
}

RenderingSources wang_sources(ImageView<const V3f> tile_luv, V2i tiles, uint32_t seed) {
  const WangTiling tiling(tile_luv, tiles, seed);
  return {picture_of<V2i>(tiling.size_px(), [&](int x, int y) { return tiling.source(x, y); }), {}, {}};
}

}  // namespace texbake
