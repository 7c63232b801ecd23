#include "libbake/draw/supersample.h"

#include <Imath/ImathVec.h>

#include "libbake/base/parallel.h"
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
  const int kind = plane_kind(plane.kind);
  const auto value = [&](glsl::Program& program, const Position& at) {
    return window.filter == Filter::nearest ? program.texel_value(texels, kind, levels, program.texel_at(at))
                                            : program.level_value(texels, kind, levels, at, 0);
  };
  return mean_rows(program_of(planes, window.seed), window, planes.size, samples, row_begin, row_end, value);
}

Image<V3f> supersampled_stack_rows(const StackPlanes& planes, const Window& window, int samples, int row_begin,
                                   int row_end) {
  const ScaleView view = scale_view(planes, window.step_256 / 256.0);
  const Window shown = window_in_scale(planes, window, view.scale);
  const V2i tile_size = planes.sizes[static_cast<size_t>(view.scale)];
  check_window(shown, tile_size);
  const int smooth = window.filter == Filter::nearest ? 0 : 1;
  const auto value = [&](glsl::Program& program, const Position& at) {
    return program.stack_probes_value(stack_probes(view, at), smooth);
  };
  return mean_rows(program_of(planes, shown.seed, reference_near(planes, shown, view.scale)), shown, tile_size, samples,
                   row_begin, row_end, value);
}

}  // namespace texbake
