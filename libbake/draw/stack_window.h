// Windows of a stack of scales: which scale shows at a step, and its rows.
// Based on: Vanhoey et al. 2013, §6.
#pragma once

#include "libbake/draw/frame.h"
#include "libbake/draw/window_program.h"
#include "libbake/planes/stack_planes.h"

namespace texbake {

/// What shows where a pixel covers some texels: a scale, and how far it has faded into the one before it.
struct ScaleView {
  int scale = 0;
  float fading = 0;     ///< 0 … 1
  float variation = 1;  ///< share of its variation that the scale still has
  int level_256 = 0;    ///< its level of detail, 256 times
};

/// `texels` of the finest scale lie along a pixel. A scale shows alone as long as its texels are pixels or larger; it
/// has faded, by the logarithm of the distance, where those of the scale before it are as large as pixels. Its
/// variation goes `variation_fade` times sooner.
ScaleView scale_view(const StackPlanes& planes, double texels);

/// The same for a window, with the level of detail that its filter asks for: that of its step in the scale that shows.
ScaleView scale_view(const StackPlanes& planes, const Window& window);

/// Origin and step of a window count in texels of the finest scale. Throws as check_window does.
Image<V3f> render_stack_rows(const StackPlanes& planes, const Window& window, int row_begin, int row_end);

/// The same with a view of the caller's choice.
Image<V3f> render_scale_rows(const StackPlanes& planes, const Window& window, const ScaleView& view, int row_begin,
                             int row_end);

/// What the text calls StackProbes: one point.
glsl::StackProbes stack_probes(const ScaleView& view, const glsl::Position& at);

/// The planes, bound for a window, which counts in texels of the finest scale. Throws as check_window does.
glsl::Program window_program_of(const StackPlanes& planes, const Window& window);

/// The center of pixel (i, j) in `scale`, which is in use then: exactly that of the finest scale, rounded down to 1/256
/// texel. Windows of one step hence fit together wherever they begin.
glsl::Position stack_pixel_position(glsl::Program& program, const Window& window, int scale, int i, int j);

/// The window with the decisions of `view.scale` behind it, point by point, for comparison with a GPU.
Frame reference_stack_frame(const StackPlanes& planes, const Window& window, const ScaleView& view);

}  // namespace texbake
