#include "libbake/gl/gl_rows.h"

#include <algorithm>

#include "libbake/draw/window_part.h"

namespace texbake {
namespace {

/// The least that GL 3.3 lets a driver have as its largest texture; ES 3.0 asks for 2048.
constexpr int kTileSide = 1024;

void place(const Image<glsl::vec4>& tile, V2i at, Image<V3f>& rows) {
  for (int y = 0; y < tile.height(); ++y)
    for (int x = 0; x < tile.width(); ++x) {
      const glsl::vec4& value = tile(x, y);
      rows(at.x + x, at.y + y) = {value.x, value.y, value.z};
    }
}

/// draw(part) for parts of rows of the window.
template <class Draw>
Image<V3f> rows_of(const Window& window, V2i tile_size, int row_begin, int row_end, const Draw& draw) {
  check_window(window, tile_size);
  Image<V3f> rows(window.width, row_end - row_begin);
  for (int y = 0; y < rows.height(); y += kTileSide)
    for (int x = 0; x < rows.width(); x += kTileSide) {
      const V2i size(std::min(kTileSide, rows.width() - x), std::min(kTileSide, rows.height() - y));
      place(draw(part_of(window, tile_size, {x, row_begin + y}, size)).values, {x, y}, rows);
    }
  return rows;
}

}  // namespace

Image<V3f> gl_rows(GlRenderer& renderer, const EvaluatorPlanes& planes, const Plane& plane, const Window& window,
                   int row_begin, int row_end) {
  return rows_of(window, planes.size, row_begin, row_end,
                 [&](const Window& part) { return renderer.draw(part, plane); });
}

Image<V3f> gl_rows(GlRenderer& renderer, const StackPlanes& planes, const Direction& viewer, const Window& window,
                   int row_begin, int row_end) {
  const ScaleView view = scale_view(planes, window);
  return rows_of(window, planes.sizes.back(), row_begin, row_end,
                 [&](const Window& part) { return renderer.draw(part, view, viewer); });
}

}  // namespace texbake
