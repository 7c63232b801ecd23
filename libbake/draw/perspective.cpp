#include "libbake/draw/perspective.h"

#include "libbake/base/parallel.h"
#include "libbake/draw/view_program.h"

namespace texbake {
namespace {

using glsl::PerspectiveProgram;
using glsl::sampler2D;
using glsl::Sight;
using glsl::vec4;

/// A plane as the text takes it.
struct Drawn {
  sampler2D texels;
  int kind;
  sampler2D levels;

  explicit Drawn(const Plane& plane)
      : texels(sampler_of(plane.texels)), kind(plane_kind(plane.kind)), levels(sampler_of(plane.level_values)) {}
  vec4 value(PerspectiveProgram& program, const Sight& sight) const {
    if (program.view_filter == 0) return program.texel_value(texels, kind, levels, program.texel_at(sight.probes.at));
    return program.probes_value(texels, kind, levels, sight.probes);
  }
};

vec4 sky_of(const Perspective& view, const Plane& plane, const EvaluatorPlanes& planes) {
  if (&plane != &planes.base) return {0, 0, 0, 0};
  return {view.sky.x, view.sky.y, view.sky.z, 0};
}

V3f color_of(const vec4& value) { return {value.x, value.y, value.z}; }

}  // namespace

Image<V3f> render_perspective_rows(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view,
                                   int row_begin, int row_end) {
  check_perspective(view, planes.size);
  const Drawn drawn(plane);
  const PerspectiveProgram shared = perspective_program_of(planes, view);
  const V3f sky = color_of(sky_of(view, plane, planes));
  Image<V3f> rows(view.width, row_end - row_begin);
  parallel_for(0, rows.height(), [&](int j) {
    PerspectiveProgram program = shared;
    for (int i = 0; i < rows.width(); ++i) {
      const Sight sight =
          program.sight_at(point_below(view), static_cast<float>(i) + 0.5f, static_cast<float>(row_begin + j) + 0.5f);
      rows(i, j) = sight.hits ? color_of(drawn.value(program, sight)) : sky;
    }
  });
  return rows;
}

Image<V3f> supersampled_perspective_rows(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view,
                                         int samples, int row_begin, int row_end) {
  check_perspective(view, planes.size);
  const Drawn drawn(plane);
  PerspectiveProgram shared = perspective_program_of(planes, view);
  shared.view_filter = view.filter == Filter::nearest ? 0 : 1;
  const V3f sky = color_of(sky_of(view, plane, planes));
  const auto place = [&](int pixel, int k) {
    return static_cast<float>(pixel) + (static_cast<float>(k) + 0.5f) / static_cast<float>(samples);
  };
  Image<V3f> rows(view.width, row_end - row_begin);
  parallel_for(0, rows.height(), [&](int j) {
    PerspectiveProgram program = shared;
    for (int i = 0; i < rows.width(); ++i) {
      Imath::V3d sum(0);
      for (int l = 0; l < samples; ++l)
        for (int k = 0; k < samples; ++k) {
          const Sight sight = program.sight_at(point_below(view), place(i, k), place(row_begin + j, l));
          sum += Imath::V3d(sight.hits ? color_of(drawn.value(program, sight)) : sky);
        }
      rows(i, j) = V3f(sum / (double{1} * samples * samples));
    }
  });
  return rows;
}

Frame perspective_frame(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view) {
  check_perspective(view, planes.size);
  const Drawn drawn(plane);
  const PerspectiveProgram shared = perspective_program_of(planes, view);
  Frame frame{Image<vec4>(view.width, view.height, sky_of(view, plane, planes)),
              Image<PixelDecision>(view.width, view.height)};
  parallel_for(0, view.height, [&](int j) {
    PerspectiveProgram program = shared;
    for (int i = 0; i < view.width; ++i) {
      const Sight sight =
          program.sight_at(point_below(view), static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f);
      if (!sight.hits) continue;
      frame.values(i, j) = drawn.value(program, sight);
      const glsl::Probes& probes = sight.probes;
      frame.decisions(i, j) = {
          static_cast<uint32_t>(probes.at.offset.x), static_cast<uint32_t>(probes.at.offset.y),
          static_cast<uint32_t>(probes.level_256) | (static_cast<uint32_t>(probes.halvings) + 1u) << 16,
          (static_cast<uint32_t>(probes.axis_256.x) & 65535u) | static_cast<uint32_t>(probes.axis_256.y) << 16};
    }
  });
  return frame;
}

}  // namespace texbake
