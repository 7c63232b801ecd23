#include "libbake/draw/window_rows.h"

#include <algorithm>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/draw/window_program.h"
#include "libbake/reference/row_program.h"

namespace texbake {
namespace {

using glsl::Position;
using glsl::Texel;
using glsl::vec4;

/// Consecutive rows drawn by one task: bilinear rows share the texel rows between them.
constexpr int kRowsInTask = 32;

V3f color_of(const vec4& value) { return {value.x, value.y, value.z}; }

/// Position of pixel (i, j): the columns and rows of a window are independent.
Position position_of(glsl::Program& program, const Window& window, int i, int j) {
  return program.pixel_position(origin_of(window), window.step_256,
                                {static_cast<uint32_t>(i), static_cast<uint32_t>(j)});
}

/// Where a column of pixels reads: the texel column that its filter sees first, and the weight of the next.
struct Column {
  uint32_t texel = 0;  ///< into Columns::texels
  float weight = 0;
};

/// The texel columns that a window sees, each once; their rows are not used. Neighboring pixels share columns.
struct Columns {
  std::vector<Texel> texels;
  std::vector<Column> pixels;
};

bool same_column(const Texel& a, const Texel& b) { return a.p.x == b.p.x && a.tile.x == b.tile.x; }

Columns nearest_columns(RowProgram program, const Window& window) {
  Columns columns;
  for (int i = 0; i < window.width; ++i) {
    const Texel texel = program.texel_at(position_of(program, window, i, 0));
    if (columns.texels.empty() || !same_column(columns.texels.back(), texel)) columns.texels.push_back(texel);
    columns.pixels.push_back({static_cast<uint32_t>(columns.texels.size()) - 1, 0});
  }
  return columns;
}

Columns bilinear_columns(RowProgram program, const Window& window) {
  Columns columns;
  auto& texels = columns.texels;
  for (int i = 0; i < window.width; ++i) {
    const Position corner = program.upper_left_center(position_of(program, window, i, 0));
    const Texel left = program.texel_at(corner);
    // The pixel before ends with its right column: this one begins there, or one before, or beyond.
    const bool shares_both = texels.size() > 1 && same_column(texels[texels.size() - 2], left);
    if (!shares_both) {
      if (texels.empty() || !same_column(texels.back(), left)) texels.push_back(left);
      texels.push_back(program.right_of(left));
    }
    columns.pixels.push_back({static_cast<uint32_t>(texels.size()) - 2, program.weight_of(corner.offset.x & 255)});
  }
  return columns;
}

/// The value of every texel column in one texel row.
template <class Value>
void fill_row(RowProgram& program, const Value& value, const Columns& columns, const Texel& row,
              std::vector<vec4>& values) {
  for (size_t k = 0; k < columns.texels.size(); ++k) {
    const Texel& column = columns.texels[k];
    values[k] = value(program, Texel{{column.tile.x, row.tile.y}, {column.p.x, row.p.y}});
  }
}

template <class Value>
void draw_nearest(RowProgram program, const Value& value, const Window& window, const Columns& columns, int row_begin,
                  ImageView<V3f> rows) {
  std::vector<vec4> values(columns.texels.size());
  for (int j = 0; j < rows.height(); ++j) {
    fill_row(program, value, columns, program.texel_at(position_of(program, window, 0, row_begin + j)), values);
    for (int i = 0; i < rows.width(); ++i) rows(i, j) = color_of(values[columns.pixels[static_cast<size_t>(i)].texel]);
  }
}

/// One texel row, blended along x for every pixel of a window.
class BlendedRow {
 public:
  explicit BlendedRow(size_t width) : values_(width) {}

  bool holds(const Texel& row) const { return filled_ && tile_ == row.tile.y && p_ == row.p.y; }

  void fill(RowProgram& program, const Columns& columns, const Texel& row, const std::vector<vec4>& texels) {
    filled_ = true;
    tile_ = row.tile.y;
    p_ = row.p.y;
    for (size_t i = 0; i < values_.size(); ++i) {
      const Column& column = columns.pixels[i];
      values_[i] = program.lerp(texels[column.texel], texels[column.texel + 1], column.weight);
    }
  }

  const vec4& operator[](size_t i) const { return values_[i]; }

 private:
  std::vector<vec4> values_;
  bool filled_ = false;
  uint32_t tile_ = 0;
  int p_ = 0;
};

/// The bilinear filter of the shader, x first: the blended texel rows are kept from one row of pixels to the next.
template <class Value>
void draw_bilinear(RowProgram program, const Value& value, const Window& window, const Columns& columns, int row_begin,
                   ImageView<V3f> rows) {
  std::vector<vec4> texels(columns.texels.size());
  BlendedRow upper(columns.pixels.size()), lower(columns.pixels.size());
  const auto fill = [&](BlendedRow& blended, const Texel& row) {
    if (blended.holds(row)) return;
    fill_row(program, value, columns, row, texels);
    blended.fill(program, columns, row, texels);
  };
  for (int j = 0; j < rows.height(); ++j) {
    const Position corner = program.upper_left_center(position_of(program, window, 0, row_begin + j));
    const Texel row = program.texel_at(corner);
    if (lower.holds(row)) std::swap(upper, lower);
    fill(upper, row);
    fill(lower, program.below(row));

    const float weight = program.weight_of(corner.offset.y & 255);
    V3f* pixels = rows.row(j);
    for (size_t i = 0; i < columns.pixels.size(); ++i) pixels[i] = color_of(program.lerp(upper[i], lower[i], weight));
  }
}

/// Every pixel by itself: value(program, its position).
template <class Value>
Image<V3f> draw_pixels(const glsl::Program& shared, const Window& window, int row_begin, int row_end,
                       const Value& value) {
  Image<V3f> rows(window.width, row_end - row_begin);
  parallel_for(0, rows.height(), [&](int j) {
    glsl::Program program = shared;
    for (int i = 0; i < rows.width(); ++i)
      rows(i, j) = color_of(value(program, position_of(program, window, i, row_begin + j)));
  });
  return rows;
}

/// At one level of detail.
Image<V3f> draw_levels(const glsl::Program& program, const Plane& plane, const Window& window, int level_256,
                       int row_begin, int row_end) {
  const glsl::sampler2D texels = sampler_of(plane.texels), levels = sampler_of(plane.level_values);
  const int kind = plane_kind(plane.kind);
  return draw_pixels(program, window, row_begin, row_end, [=](glsl::Program& p, const Position& at) {
    return p.trilinear_value(texels, kind, levels, at, level_256);
  });
}

Image<V3f> draw_deformed(const EvaluatorPlanes& planes, const Window& window, int row_begin, int row_end) {
  const int kind = plane_kind(planes.base.kind), level_256 = level_256_of(window, planes.level_count);
  const int smooth = smooth_filter(window.filter);
  return draw_pixels(program_of(planes, window), window, row_begin, row_end, [=](glsl::Program& p, const Position& at) {
    return p.deformed_value(p.base, kind, p.base_levels, at, smooth, level_256);
  });
}

/// At level 0, `value` being that of a texel.
template <class Value>
Image<V3f> draw(const glsl::Program& program, const Value& value, const Window& window, int row_begin, int row_end) {
  const RowProgram row_program(program);
  const Columns columns =
      window.filter == Filter::nearest ? nearest_columns(row_program, window) : bilinear_columns(row_program, window);
  Image<V3f> rows(window.width, row_end - row_begin);
  const int tasks = (rows.height() + kRowsInTask - 1) / kRowsInTask;
  parallel_for(0, tasks, [&](int task) {
    const int first = task * kRowsInTask;
    const ImageView<V3f> part(rows.row(first), rows.width(), std::min(kRowsInTask, rows.height() - first));
    if (window.filter == Filter::nearest)
      draw_nearest(row_program, value, window, columns, row_begin + first, part);
    else
      draw_bilinear(row_program, value, window, columns, row_begin + first, part);
  });
  return rows;
}

/// At level 0; `value` is what a texel shows of `plane` where one patch alone counts.
template <class Value>
Image<V3f> draw_texels(const EvaluatorPlanes& planes, const Plane& plane, const Window& window, const Value& value,
                       int row_begin, int row_end) {
  const glsl::Program program = program_of(planes, window.seed);
  if (planes.first_level != 0) return draw(program, value, window, row_begin, row_end);
  const glsl::sampler2D texels = sampler_of(plane.texels), levels = sampler_of(plane.level_values);
  const int kind = plane_kind(plane.kind);
  const auto soft_value = [=](RowProgram& row, const Texel& texel) {
    const bool is_shared = (row.shared_texel(texel).y >> 20u) != 0;
    return is_shared ? row.texel_value(texels, kind, levels, texel) : value(row, texel);
  };
  return draw(program, soft_value, window, row_begin, row_end);
}

}  // namespace

Image<V3f> render_rows(const EvaluatorPlanes& planes, const Window& window, int row_begin, int row_end) {
  check_window(window, planes.size);
  if (!window.deformation.is_identity()) return draw_deformed(planes, window, row_begin, row_end);
  if (const int level_256 = level_256_of(window, planes.level_count); level_256 > 0)
    return draw_levels(program_of(planes, window.seed), planes.base, window, level_256, row_begin, row_end);
  const auto value = [](RowProgram& program, const Texel& texel) {
    return program.layered_value(program.base, texel, program.texel_source(texel));
  };
  return draw_texels(planes, planes.base, window, value, row_begin, row_end);
}

Image<V3f> render_map_rows(const EvaluatorPlanes& planes, const Plane& map, const Window& window, int row_begin,
                           int row_end) {
  check_window(window, planes.size);
  if (const int level_256 = level_256_of(window, planes.level_count); level_256 > 0)
    return draw_levels(program_of(planes, window.seed), map, window, level_256, row_begin, row_end);
  const glsl::sampler2D plane = sampler_of(map.texels);
  const auto draw_with = [&](const auto& value) { return draw_texels(planes, map, window, value, row_begin, row_end); };
  switch (map.kind) {
    case MapKind::normal_opengl:
    case MapKind::normal_directx: {
      const float up = map.kind == MapKind::normal_opengl ? 1.0f : -1.0f;
      return draw_with(
          [=](RowProgram& p, const Texel& texel) { return p.source_normal(plane, p.texel_source(texel), up); });
    }
    case MapKind::height:
      return draw_with(
          [=](RowProgram& p, const Texel& texel) { return p.source_height(plane, p.texel_source(texel)); });
    case MapKind::structure:
      return draw_with(
          [=](RowProgram& p, const Texel& texel) { return p.layered_value(plane, texel, p.texel_source(texel)); });
    case MapKind::plain:
    case MapKind::relief_opengl:
    case MapKind::relief_directx:
      break;
  }
  return draw_with([=](RowProgram& p, const Texel& texel) { return p.source_value(plane, p.texel_source(texel)); });
}

}  // namespace texbake
