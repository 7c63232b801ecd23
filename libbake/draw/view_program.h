// Binds a perspective view to the reference text.
#pragma once

#include "libbake/draw/perspective_view.h"
#include "libbake/planes/program_of.h"
#include "libbake/reference/perspective_program.h"

namespace texbake {

/// What the text calls view_filter.
inline int view_filter(Filter filter) { return static_cast<int>(filter); }
static_assert(static_cast<int>(Filter::nearest) == glsl::kFilterNearest &&
              static_cast<int>(Filter::bilinear) == glsl::kFilterBilinear &&
              static_cast<int>(Filter::trilinear) == glsl::kFilterTrilinear &&
              static_cast<int>(Filter::anisotropic) == glsl::kFilterAnisotropic);

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
