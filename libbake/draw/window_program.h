// Binds a window to the reference text.
#pragma once

#include "libbake/draw/window.h"
#include "libbake/planes/program_of.h"

namespace texbake {

/// What the text calls smooth_filter.
inline int smooth_filter(Filter filter) {
  return filter == Filter::nearest ? glsl::kFilterNearest : glsl::kFilterBilinear;
}

/// The upper left corner of a window.
inline glsl::Position origin_of(const Window& window) {
  return {{window.origin_x.tile, window.origin_y.tile},
          {static_cast<int>(window.origin_x.offset_256), static_cast<int>(window.origin_y.offset_256)}};
}

/// The planes, bound for one window, deformed as it asks, from the texel at its corner on. Where it is deformed and has
/// levels of detail, the grain of the planes is expected to be apart.
inline glsl::Program program_of(const EvaluatorPlanes& planes, const Window& window) {
  glsl::Program program = program_of(planes, window.seed);
  const glsl::Texel corner = program.texel_at(origin_of(window));
  const Deformation& deformation = window.deformation;
  const DeformationAnchor to =
      anchor_of(deformation, planes.size, {corner.tile.x, corner.tile.y}, {corner.p.x, corner.p.y});
  const bool has_levels = window.filter == Filter::trilinear || window.filter == Filter::anisotropic;
  const DeformedFootprint footprint =
      has_levels ? footprint_of(deformation, window.step_256 / 256.0, window.filter == Filter::anisotropic ? 4 : 0,
                                planes.level_count)
                 : DeformedFootprint{};
  const int32_t(&matrix)[4] = deformation.matrix;
  program.deformed = deformation.is_identity() ? 0 : 1;
  program.deform_matrix = {matrix[0], matrix[1], matrix[2], matrix[3]};
  program.deform_from_tile = corner.tile;
  program.deform_from = corner.p;
  program.deform_to_tile = {to.tile[0], to.tile[1]};
  program.deform_to = {to.texel[0], to.texel[1], to.fraction_65536[0], to.fraction_65536[1]};
  program.deform_axis_256 = {footprint.axis_256[0], footprint.axis_256[1]};
  program.deform_probes = {footprint.level_256, footprint.halvings};
  program.turbulence = {deformation.turbulence_256, deformation.turbulence_cell_log2};
  return program;
}

}  // namespace texbake
