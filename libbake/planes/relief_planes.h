// The relief of a stack's coarsest scale with its levels of detail, as shaders/relief_bindings.glsl has it.
// Based on: Policarpo, Oliveira and Comba 2005; Vanhoey et al. 2013, §7.
#pragma once

#include "libbake/planes/prepare.h"
#include "libbake/planes/relief.h"
#include "libbake/reference/program.h"

namespace texbake {

/// One texel of zeros each where there is no relief.
struct ReliefPlanes : glsl::ReliefUniforms {
  Image<glsl::vec4> height_plane{1, 1, {0, 0, 0, 0}};   ///< height; x, y, z of the normal
  Image<glsl::vec4> height_levels{1, 1, {0, 0, 0, 0}};  ///< the same of levels of detail
};

template <class Visitor>
void for_each_texture(const ReliefPlanes& relief, Visitor&& visit) {
  using S = glsl::Samplers;
  visit(Texture{"height_plane"}, relief.height_plane, &S::height_plane);
  visit(Texture{"height_levels", Precision::half}, relief.height_levels, &S::height_levels);
}

/// `coarsest` as the stack has it, with the map "height". The normals are those of the material, or those of the
/// heights: by central differences, at the depth of the options. Borders of patches are hard. Throws Error(usage) when
/// a map that is needed is not there, and for a light that does not come from above.
ReliefPlanes relief_planes(const EvaluatorInput& coarsest, const ReliefOptions& options, const Direction& light);

/// Borrows `relief`.
void bind_relief(glsl::Program& program, const ReliefPlanes& relief);

}  // namespace texbake
