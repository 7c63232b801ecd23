// Windows by brute force: the mean of many points of every pixel. The truth that filters are measured by.
#pragma once

#include "libbake/draw/stack_window.h"
#include "libbake/planes/evaluator_planes.h"
#include "libbake/planes/relief_planes.h"

namespace texbake {

/// Rows row_begin ≤ j < row_end of the window, each pixel the mean in double of samples × samples points of level 0,
/// evenly spaced in it and rounded down to 1/256 texel; a point is the texel that it lies in where the window's filter
/// is nearest, else bilinear. With nearest and as many samples as texels, a pixel is the box mean of its texels.
Image<V3f> supersampled_rows(const EvaluatorPlanes& planes, const Plane& plane, const Window& window, int samples,
                             int row_begin, int row_end);

/// The same of a stack, whose window counts in texels of the finest scale: points of level 0 of the scales that show at
/// its step, faded as they are there, moved and lit by `relief` where there is one, as `viewer` sees it.
Image<V3f> supersampled_stack_rows(const StackPlanes& planes, const ReliefPlanes* relief, const Direction& viewer,
                                   const Window& window, int samples, int row_begin, int row_end);

}  // namespace texbake
