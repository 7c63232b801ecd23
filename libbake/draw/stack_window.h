// Windows of a stack of scales: which scale shows at a step, and its rows.
// Based on: Vanhoey et al. 2013, §6.
#pragma once

#include "libbake/draw/frame.h"
#include "libbake/draw/window.h"
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

/// The same with a view of the caller's choice. The window counts in texels of `view.scale`.
Image<V3f> render_scale_rows(const StackPlanes& planes, const Window& window, const ScaleView& view, int row_begin,
                             int row_end);

/// What the text calls StackProbes: one point.
glsl::StackProbes stack_probes(const ScaleView& view, const glsl::Position& at);

/// What the text calls smooth_filter.
inline int smooth_filter(Filter filter) {
  return filter == Filter::nearest ? glsl::kFilterNearest : glsl::kFilterBilinear;
}

/// A window that counts in texels of the finest scale, in texels of a coarser one; its step is at least 1/256 there.
Window window_in_scale(const StackPlanes& planes, const Window& window, int scale);

/// A repetition of the finest tile near a window that counts in texels of `scale`: the reference of program_of.
glsl::uvec2 reference_near(const StackPlanes& planes, const Window& window, int scale);

/// The window with the decisions of `view.scale` behind it, point by point, for comparison with a GPU.
Frame reference_stack_frame(const StackPlanes& planes, const Window& window, const ScaleView& view);

}  // namespace texbake
