// Draws windows of any size with the reference shader, in tiles that every driver can draw.
#pragma once

#include "libbake/gl/gl_renderer.h"

namespace texbake {

/// Rows row_begin ≤ j < row_end of the window, as render_rows and render_map_rows give them: `plane` is the planes'
/// base or one of its maps, and `planes` those that the renderer was made with.
Image<V3f> gl_rows(GlRenderer& renderer, const EvaluatorPlanes& planes, const Plane& plane, const Window& window,
                   int row_begin, int row_end);

/// The same of a stack, as render_stack_rows gives them or, with a renderer that has relief, render_relief_rows.
Image<V3f> gl_rows(GlRenderer& renderer, const StackPlanes& planes, const Direction& viewer, const Window& window,
                   int row_begin, int row_end);

}  // namespace texbake
