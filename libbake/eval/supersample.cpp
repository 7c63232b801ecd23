#include "libbake/eval/supersample.h"

#include <Imath/ImathVec.h>

#include "libbake/base/parallel.h"
#include "libbake/eval/row_program.h"

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

}  // namespace

Image<V3f> supersampled_rows(const EvaluatorPlanes& planes, const Plane& plane, const Window& window, int samples,
                             int row_begin, int row_end) {
  check_window(window, planes.size);
  const glsl::Program shared = program_of(planes, window.seed);
  const glsl::sampler2D texels = sampler_of(plane.texels), levels = sampler_of(plane.level_values);
  const int kind = plane_kind(plane.kind);
  Image<V3f> rows(window.width, row_end - row_begin);
  parallel_for(0, rows.height(), [&](int j) {
    RowProgram program(shared);
    const auto point = [&](const TileOffset& x, const TileOffset& y) {
      const Position at{{x.tile, y.tile}, {static_cast<int>(x.offset_256), static_cast<int>(y.offset_256)}};
      return window.filter == Filter::nearest ? program.texel_value(texels, kind, levels, program.texel_at(at))
                                              : program.level_value(texels, kind, levels, at, 0);
    };
    for (int i = 0; i < rows.width(); ++i) {
      Imath::V3d sum(0);
      for (int l = 0; l < samples; ++l)
        for (int k = 0; k < samples; ++k) {
          const vec4 value = point(after(window.origin_x, place_256(window, i, k, samples), planes.size.x),
                                   after(window.origin_y, place_256(window, row_begin + j, l, samples), planes.size.y));
          sum += Imath::V3d(double{value.x}, double{value.y}, double{value.z});
        }
      rows(i, j) = V3f(sum / (double{1} * samples * samples));
    }
  });
  return rows;
}

}  // namespace texbake
