// A window with the decisions behind it: what the processor and a GPU are compared by.
#pragma once

#include "libbake/draw/window.h"
#include "libbake/planes/evaluator_planes.h"

namespace texbake {

/// What was decided for the texel in which a pixel's center lies.
struct PixelDecision {
  uint32_t patch_idx = 0;
  uint32_t content = 0;
  uint32_t source_x = 0;  ///< the texel of the tile that gives labels there
  uint32_t source_y = 0;
  bool operator==(const PixelDecision&) const = default;
};

struct Frame {
  Image<glsl::vec4> values;  ///< of the base or of a map, all four channels
  Image<PixelDecision> decisions;
};

/// The frame by the reference text, point by point; in parallel. `plane` is the planes' base or one of its maps.
Frame reference_frame(const EvaluatorPlanes& planes, const Window& window, const Plane& plane);

}  // namespace texbake
