// Draws windows of the infinite texture, by rows, so that pictures of any size fit in bounded memory.
// Based on: Vanhoey et al. 2013, §5.3. The meaning is shaders/README.md; the text that runs is shaders/*.glsl.
#pragma once

#include "libbake/draw/window.h"
#include "libbake/planes/evaluator_planes.h"

namespace texbake {

/// Rows row_begin ≤ j < row_end of the window: colors of the base, linear Rec.709. The result does not depend on how
/// a window is cut into rows, nor on threads.
Image<V3f> render_rows(const EvaluatorPlanes& planes, const Window& window, int row_begin, int row_end);

/// The same of a map, without deformation, its channels in x, y, z; those that it lacks are 0. Normals turn with their
/// content, are not normalized, and keep their convention; heights shrink with their content.
Image<V3f> render_map_rows(const EvaluatorPlanes& planes, const Plane& map, const Window& window, int row_begin,
                           int row_end);

}  // namespace texbake
