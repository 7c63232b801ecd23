#include "libbake/draw/supersample.h"

#include <Imath/ImathVec.h>

#include "libbake/base/parallel.h"
#include "libbake/draw/relief_window.h"
#include "libbake/draw/window_program.h"

namespace texbake {
namespace {

using glsl::Position;
using glsl::vec4;

/// Sample k of pixel i of an axis, in 1/256 texel from the window's corner.
uint64_t place_256(const Window& window, int i, int k, int samples) {
  const uint64_t twice = (2 * static_cast<uint64_t>(k) + 1) * window.step_256;
  return static_cast<uint64_t>(i) * window.step_256 + twice / (2 * static_cast<uint64_t>(samples));
}

/// A coordinate `by_256` after the window's corner.
TileOffset after(const TileOffset& corner, uint64_t by_256, int side) {
  const uint64_t period = static_cast<uint64_t>(side) * 256;
  const uint64_t place = corner.offset_256 + by_256;
  return {corner.tile + static_cast<uint32_t>(place / period), static_cast<uint32_t>(place % period)};
}

/// The mean of value(program, point) over samples × samples points of every pixel.
template <class Value>
Image<V3f> mean_rows(const glsl::Program& shared, const Window& window, V2i tile_size, int samples, int row_begin,
                     int row_end, const Value& value) {
  Image<V3f> rows(window.width, row_end - row_begin);
  parallel_for(0, rows.height(), [&](int j) {
    glsl::Program program = shared;
    for (int i = 0; i < rows.width(); ++i) {
      Imath::V3d sum(0);
      for (int l = 0; l < samples; ++l)
        for (int k = 0; k < samples; ++k) {
          const TileOffset x = after(window.origin_x, place_256(window, i, k, samples), tile_size.x);
          const TileOffset y = after(window.origin_y, place_256(window, row_begin + j, l, samples), tile_size.y);
          const Position at{{x.tile, y.tile}, {static_cast<int>(x.offset_256), static_cast<int>(y.offset_256)}};
          const vec4 color = value(program, at);
          sum += Imath::V3d(double{color.x}, double{color.y}, double{color.z});
        }
      rows(i, j) = V3f(sum / (double{1} * samples * samples));
    }
  });
  return rows;
}

}  // namespace

Image<V3f> supersampled_rows(const EvaluatorPlanes& planes, const Plane& plane, const Window& window, int samples,
                             int row_begin, int row_end) {
  check_window(window, planes.size);
  const glsl::sampler2D texels = sampler_of(plane.texels), levels = sampler_of(plane.level_values);
  const int kind = plane_kind(plane.kind), smooth = smooth_filter(window.filter);
  Window point = window;  // of level 0, whatever its pixels see
  point.filter = smooth == glsl::kFilterNearest ? Filter::nearest : Filter::bilinear;
  const auto value = [=](glsl::Program& program, const Position& at) {
    if (program.deformed != 0) return program.deformed_value(texels, kind, levels, at, smooth, 0);
    return smooth == glsl::kFilterNearest ? program.texel_value(texels, kind, levels, program.texel_at(at))
                                          : program.level_value(texels, kind, levels, at, 0);
  };
  glsl::Program bound = program_of(planes, point);
  if (&plane != &planes.base) bound.deformed = 0;  // as Window says, maps are not
  return mean_rows(bound, window, planes.size, samples, row_begin, row_end, value);
}

Image<V3f> supersampled_stack_rows(const StackPlanes& planes, const ReliefPlanes* relief, const Direction& viewer,
                                   const Window& window, int samples, int row_begin, int row_end) {
  const ScaleView view = scale_view(planes, window.step_256 / 256.0);
  const int smooth = smooth_filter(window.filter);
  glsl::Program bound = window_program_of(planes, window);
  if (relief) bind_relief(bound, *relief);
  glsl::vec3 slant = slant_of(planes, viewer, window);
  slant.z = kPointWidth;
  const auto value = [&](glsl::Program& program, const Position& at) {
    const Position seen = program.position_in_scale(at, planes.finest(), view.scale);
    return program.sight_value(program.window_sight(stack_probes(view, seen), slant), smooth);
  };
  return mean_rows(bound, window, planes.sizes.back(), samples, row_begin, row_end, value);
}

}  // namespace texbake
