// Deformation of the structure by the artist, while the grain of a texture of two layers keeps its size and direction.
// Based on: Guingo et al. 2017, §4, Fig. 3 and 10. The meaning is shaders/README.md; the text is shaders/deform.glsl.
#pragma once

#include <cstdint>

#include "libbake/base/torus.h"

namespace texbake {

/// As the shader binds it.
struct Deformation {
  int32_t matrix[4] = {65536, 0, 0, 65536};  ///< structure from picture: rows (xx, xy), (yx, yy), 1/65536, |.| ≤ 2^17
  int turbulence_256 = 0;                    ///< amplitude in 1/256 texel, at most 2^14
  int turbulence_cell_log2 = 6;              ///< of the coarsest cells in texels, 6 … 10

  bool is_identity() const;
};

/// What an artist asks for: the structure appears `stretch` times its size along x and y, then turned by
/// `rotate_degrees` from x towards y (clockwise as seen), about the origin of the infinite texture, then displaced by
/// smooth noise of up to `turbulence_texels` (1.75 times that where octaves agree).
struct DeformationRequest {
  double rotate_degrees = 0;
  double stretch_x = 1;  ///< 0.5 … 64
  double stretch_y = 1;
  double turbulence_texels = 0;  ///< 0 … 64
  int turbulence_cell = 64;      ///< texels, a power of two from 64 to 1024
};

/// Throws Error(usage) for values out of range.
Deformation deformation_of(const DeformationRequest& request);

/// What a pixel of a window sees of the structure: points in a row along the longer axis of its footprint, at one level
/// of detail. Turbulence, whose slopes are gentle, does not widen it.
struct DeformedFootprint {
  int axis_256[2] = {0, 0};  ///< from its one end to the other, 1/256 texel
  int halvings = 0;          ///< 2^halvings points
  int level_256 = 0;         ///< 0 … 256 (level_count + 1)
};

/// Of a pixel `texels` wide, at least one: the ellipse that the deformation makes of a circle (Heckbert 1989). At most
/// 2^most_halvings points; where that is not enough for its shorter axis, they are as wide as it takes.
DeformedFootprint footprint_of(const Deformation& deformation, double texels, int most_halvings, int level_count);

/// Where the deformation takes the center of texel (`texel`) of repetition (`tile`) from, exactly: tiles count as
/// signed, so that a deformed picture is of one piece up to 2^31 repetitions from the origin.
struct DeformationAnchor {
  uint32_t tile[2] = {0, 0};
  int texel[2] = {0, 0};
  int fraction_65536[2] = {0, 0};
};
DeformationAnchor anchor_of(const Deformation& deformation, V2i tile_size, const uint32_t (&tile)[2], V2i texel);

}  // namespace texbake
