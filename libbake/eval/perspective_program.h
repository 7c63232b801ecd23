// The text of the perspective view as a C++ type, on top of Program.
// Included only by sources of libbake/eval and by tests.
#pragma once

#include "libbake/eval/perspective.h"
#include "libbake/eval/program_of.h"

namespace texbake::glsl {

struct PerspectiveProgram : Program {
  vec3 view_corner{0, 0, 1};
  vec3 view_right{0, 0, 0};
  vec3 view_down{0, 0, 0};
  float view_height = 1;
  int view_filter = 1;

#define PRECISE
#include "shaders/perspective.glsl"
//
#include "shaders/stack_perspective.glsl"
#undef PRECISE
};

using Sight = PerspectiveProgram::Sight;

}  // namespace texbake::glsl

namespace texbake {

/// What the text calls view_filter.
inline int view_filter(Filter filter) { return static_cast<int>(filter); }
static_assert(static_cast<int>(Filter::nearest) == 0 && static_cast<int>(Filter::anisotropic) == 3);

/// The point under the camera.
inline glsl::Position point_below(const Perspective& view) {
  return {{view.origin_x.tile, view.origin_y.tile},
          {static_cast<int>(view.origin_x.offset_256), static_cast<int>(view.origin_y.offset_256)}};
}

/// `bound` with the camera.
inline glsl::PerspectiveProgram with_view(const glsl::Program& bound, const Perspective& view) {
  const PerspectiveRays rays = rays_of(view);
  glsl::PerspectiveProgram program;
  static_cast<glsl::Program&>(program) = bound;
  program.view_corner = rays.corner;
  program.view_right = rays.right;
  program.view_down = rays.down;
  program.view_height = rays.height;
  program.view_filter = view_filter(view.filter);
  return program;
}

/// Borrows `planes`.
inline glsl::PerspectiveProgram perspective_program_of(const EvaluatorPlanes& planes, const Perspective& view) {
  return with_view(program_of(planes, view.seed), view);
}

}  // namespace texbake
