// Draws a stack of scales as an endless plane in perspective, by rows. What a pixel sees is
// shaders/stack_perspective.glsl.
#pragma once

#include "libbake/draw/perspective.h"
#include "libbake/planes/relief_planes.h"
#include "libbake/planes/stack_planes.h"

namespace texbake {

/// Rows row_begin ≤ j < row_end of the picture. Origin and height of the view count in texels of the finest scale.
/// `relief`, where it is given, is that of the coarsest scale. The result does not
/// depend on how it is cut into rows, nor on threads. Throws as check_perspective does.
Image<V3f> render_stack_perspective_rows(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view,
                                         int row_begin, int row_end);

/// The same with the mean of samples × samples points of every pixel, each bilinear at level 0 (nearest where the
/// filter is) of the scales that the pixel sees, faded as they are there, with relief of its own: the truth that
/// filters are measured by.
Image<V3f> supersampled_stack_perspective_rows(const StackPlanes& planes, const ReliefPlanes* relief,
                                               const Perspective& view, int samples, int row_begin, int row_end);

/// The whole picture with what was found before the exact path, as shaders/stack_perspective.frag writes it.
Frame stack_perspective_frame(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view);

}  // namespace texbake
