// The relief of a stack's coarsest scale with its levels of detail, as shaders/relief_bindings.glsl has it.
// Based on: Policarpo, Oliveira and Comba 2005; Vanhoey et al. 2013, §7.
#pragma once

#include "libbake/planes/prepare.h"
#include "libbake/planes/relief.h"
#include "libbake/reference/program.h"

namespace texbake {

struct ReliefPlanes {
  Image<glsl::vec4> height_plane;   ///< height; x, y, z of the normal
  Image<glsl::vec4> height_levels;  ///< the same of levels of detail
  glsl::vec4 range{0, 0, 0, 0}, light{0, 0, 1, 0};
  glsl::ivec2 steps{1, 0};
  float depth_px = 0;  ///< texels of the coarsest scale between height 0 and 1
  int kind = 0;        ///< glsl::kPlaneReliefOpengl, kPlaneReliefDirectx or kUnlit
};

/// `coarsest` as the stack has it, with the map "height". The normals are those of the material, or those of the
/// heights: by central differences, at the depth of the options. Borders of patches are hard. Throws Error(usage) when
/// a map that is needed is not there, and for a light that does not come from above.
ReliefPlanes relief_planes(const EvaluatorInput& coarsest, const ReliefOptions& options, const Direction& light);

/// Borrows `relief`.
void bind_relief(glsl::Program& program, const ReliefPlanes& relief);

}  // namespace texbake
