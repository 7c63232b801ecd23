// Draws the infinite texture as an endless plane in perspective, by rows. What a pixel sees is
// shaders/perspective.glsl.
#pragma once

#include "libbake/draw/frame.h"
#include "libbake/draw/perspective_view.h"

namespace texbake {

/// Rows row_begin ≤ j < row_end of the picture: values of `plane`, the planes' base or one of its maps.
/// The result does not depend on how it is cut into rows, nor on threads.
Image<V3f> render_perspective_rows(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view,
                                   int row_begin, int row_end);

/// The same with the mean of samples × samples points of every pixel, each bilinear at level 0 (nearest where the
/// filter is): the truth that filters are measured by.
Image<V3f> supersampled_perspective_rows(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view,
                                         int samples, int row_begin, int row_end);

/// The whole picture with what was found before the exact path, as shaders/perspective.frag writes it: a decision holds
/// the four numbers that it calls `decided`.
Frame perspective_frame(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view);

}  // namespace texbake
