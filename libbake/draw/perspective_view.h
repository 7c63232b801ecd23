// A camera above the endless plane of the infinite texture.
#pragma once

#include "libbake/base/image.h"
#include "libbake/draw/window.h"
#include "libbake/reference/glsl.h"

namespace texbake {

/// A camera above the plane, and the picture that it takes. Looking straight down (pitch 90, yaw 0) it shows the
/// texture as a window does.
struct Perspective {
  TileOffset origin_x;  ///< the point under the camera
  TileOffset origin_y;
  double height_texels = 1024;  ///< of the camera above the plane, > 0
  double pitch_deg = 20;        ///< of the view's center below the horizon, −90 … 90
  double yaw_deg = 0;           ///< 0 looks up in the texture, 90 to its right
  double fov_deg = 50;          ///< from the picture's top to its bottom, above 0, below 180
  int width = 0;                ///< pixels
  int height = 0;
  uint32_t seed = 0;
  Filter filter = Filter::anisotropic;
  V3f sky{0.45f, 0.55f, 0.7f};  ///< where the plane is not seen; in a picture of a map 0
};

/// Throws Error(usage) when the picture is empty, a number is outside its range, or the origin outside its tile.
void check_perspective(const Perspective& view, V2i tile_size);

/// Rays as perspective.glsl takes them: right and down in the texture, and towards it.
struct PerspectiveRays {
  glsl::vec3 corner, right, down;
  float height = 1;
};
PerspectiveRays rays_of(const Perspective& view);

}  // namespace texbake
