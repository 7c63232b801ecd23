#include "libbake/eval/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "libbake/base/error.h"
#include "libbake/base/parallel.h"
#include "libbake/eval/program_of.h"

namespace texbake {
namespace {

using glsl::Position;
using glsl::Program;
using glsl::Texel;
using glsl::vec4;

/// Consecutive rows drawn by one task: bilinear rows share the texel rows between them.
constexpr int kRowsInTask = 32;

V3f color_of(const vec4& value) { return {value.x, value.y, value.z}; }

/// The values of one texel row, blended along x for every pixel of a window.
template <class Value>
class BlendedRow {
 public:
  explicit BlendedRow(int width) : values_(static_cast<size_t>(width)) {}

  bool holds(const Texel& row) const { return filled_ && tile_ == row.tile.y && p_ == row.p.y; }

  /// `columns` are the upper left texel centres of the pixels; of each, x alone is read.
  void fill(Program& program, const Value& value, const std::vector<Position>& columns, const Texel& row) {
    filled_ = true;
    tile_ = row.tile.y;
    p_ = row.p.y;
    // Neighbouring pixels share texels: `right` of one is often `left` of the next.
    Texel left_texel = row, right_texel = row;
    vec4 left{}, right{};
    bool first = true;
    for (size_t i = 0; i < columns.size(); ++i) {
      const Texel texel{{columns[i].tile.x, row.tile.y}, {columns[i].offset.x >> 8, row.p.y}};
      if (first || !same_column(texel, left_texel)) {
        left = !first && same_column(texel, right_texel) ? right : value(program, texel);
        left_texel = texel;
        right_texel = program.right_of(texel);
        right = value(program, right_texel);
        first = false;
      }
      values_[i] = program.lerp(left, right, program.weight_of(columns[i].offset.x & 255));
    }
  }

  const vec4& operator[](size_t i) const { return values_[i]; }

 private:
  static bool same_column(const Texel& a, const Texel& b) { return a.p.x == b.p.x && a.tile.x == b.tile.x; }

  std::vector<vec4> values_;
  bool filled_ = false;
  uint32_t tile_ = 0;
  int p_ = 0;
};

/// Position of pixel (i, j): the columns and rows of a window are independent.
Position position_of(Program& program, const Window& window, int i, int j) {
  const Position origin{{window.origin_x.tile, window.origin_y.tile},
                        {static_cast<int>(window.origin_x.offset_256), static_cast<int>(window.origin_y.offset_256)}};
  return program.pixel_position(origin, window.step_256, {static_cast<uint32_t>(i), static_cast<uint32_t>(j)});
}

/// What the filter needs of each column of pixels: its centre, or the upper left texel centre of four.
std::vector<Position> columns_of(Program program, const Window& window) {
  std::vector<Position> columns(static_cast<size_t>(window.width));
  for (int i = 0; i < window.width; ++i) {
    const Position at = position_of(program, window, i, 0);
    columns[static_cast<size_t>(i)] = window.filter == Filter::bilinear ? program.upper_left_center(at) : at;
  }
  return columns;
}

template <class Value>
void draw_nearest(Program program, const Value& value, const Window& window, const std::vector<Position>& columns,
                  int row_begin, ImageView<V3f> rows) {
  for (int j = 0; j < rows.height(); ++j) {
    const Position row = position_of(program, window, 0, row_begin + j);
    V3f* pixels = rows.row(j);
    for (size_t i = 0; i < columns.size(); ++i) {
      const Position at{{columns[i].tile.x, row.tile.y}, {columns[i].offset.x, row.offset.y}};
      pixels[i] = color_of(value(program, program.texel_at(at)));
    }
  }
}

/// The bilinear filter of the shader, x first: the blended texel rows are kept from one row of pixels to the next.
template <class Value>
void draw_bilinear(Program program, const Value& value, const Window& window, const std::vector<Position>& columns,
                   int row_begin, ImageView<V3f> rows) {
  BlendedRow<Value> upper(window.width), lower(window.width);
  for (int j = 0; j < rows.height(); ++j) {
    const Position corner = program.upper_left_center(position_of(program, window, 0, row_begin + j));
    const Texel row = program.texel_at(corner);
    if (lower.holds(row)) std::swap(upper, lower);
    if (!upper.holds(row)) upper.fill(program, value, columns, row);
    const Texel next = program.below(row);
    if (!lower.holds(next)) lower.fill(program, value, columns, next);

    const float weight = program.weight_of(corner.offset.y & 255);
    V3f* pixels = rows.row(j);
    for (size_t i = 0; i < columns.size(); ++i) pixels[i] = color_of(program.lerp(upper[i], lower[i], weight));
  }
}

template <class Value>
Image<V3f> draw(const Program& program, const Value& value, const Window& window, int row_begin, int row_end) {
  const std::vector<Position> columns = columns_of(program, window);
  Image<V3f> rows(window.width, row_end - row_begin);
  const int tasks = (rows.height() + kRowsInTask - 1) / kRowsInTask;
  parallel_for(0, tasks, [&](int task) {
    const int first = task * kRowsInTask;
    const ImageView<V3f> part(rows.row(first), rows.width(), std::min(kRowsInTask, rows.height() - first));
    if (window.filter == Filter::nearest)
      draw_nearest(program, value, window, columns, row_begin + first, part);
    else
      draw_bilinear(program, value, window, columns, row_begin + first, part);
  });
  return rows;
}

}  // namespace

void check_window(const Window& window, V2i tile_size) {
  if (window.width < 1 || window.height < 1)
    throw Error(ErrorKind::usage,
                fmt::format("window: expected at least 1 x 1 pixels, found {} x {}", window.width, window.height));
  if (window.step_256 < 1) throw Error(ErrorKind::usage, "window: expected a step of at least 1/256 texel, found 0");
  const auto side_256 = [](int side) { return static_cast<uint32_t>(side) * 256u; };
  if (window.origin_x.offset_256 >= side_256(tile_size.x) || window.origin_y.offset_256 >= side_256(tile_size.y))
    throw Error(ErrorKind::usage, "window: expected an origin inside its tile");
  const uint64_t longest = static_cast<uint64_t>(std::max(window.width, window.height));
  if (longest * window.step_256 + side_256(std::max(tile_size.x, tile_size.y)) > std::numeric_limits<uint32_t>::max())
    throw Error(
        ErrorKind::usage,
        fmt::format("window: expected less than 16777216 texels on each side, found {} pixels of {}/256 texels; "
                    "draw it in parts",
                    longest, window.step_256));
}

Image<V3f> render_rows(const EvaluatorPlanes& planes, const Window& window, int row_begin, int row_end) {
  check_window(window, planes.size);
  const auto value = [](Program& program, const Texel& texel) {
    return program.source_value(program.base, program.texel_source(texel));
  };
  return draw(program_of(planes, window.seed), value, window, row_begin, row_end);
}

Image<V3f> render_map_rows(const EvaluatorPlanes& planes, const Plane& map, const Window& window, int row_begin,
                           int row_end) {
  check_window(window, planes.size);
  const Program program = program_of(planes, window.seed);
  const glsl::sampler2D plane = sampler_of(map.texels);
  const auto draw_with = [&](const auto& value) { return draw(program, value, window, row_begin, row_end); };
  switch (map.kind) {
    case MapKind::normal_opengl:
    case MapKind::normal_directx: {
      const float up = map.kind == MapKind::normal_opengl ? 1.0f : -1.0f;
      return draw_with(
          [=](Program& p, const Texel& texel) { return p.source_normal(plane, p.texel_source(texel), up); });
    }
    case MapKind::height:
      return draw_with([=](Program& p, const Texel& texel) { return p.source_height(plane, p.texel_source(texel)); });
    case MapKind::plain:
      break;
  }
  return draw_with([=](Program& p, const Texel& texel) { return p.source_value(plane, p.texel_source(texel)); });
}

}  // namespace texbake
