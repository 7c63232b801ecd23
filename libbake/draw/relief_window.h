// Windows of a stack seen aslant: parallax and light of the relief of its coarsest scale.
#pragma once

#include "libbake/draw/stack_window.h"
#include "libbake/planes/relief_planes.h"

namespace texbake {

/// The width of a sample, in texels of the coarsest scale: relief is then seen without levels of detail, and parallax
/// does not fade.
inline constexpr float kPointWidth = 1e-3f;

/// `slant` of shaders/stack.frag: how the rays of pixels fall that `viewer` sees, and how wide they are in texels of
/// the coarsest scale.
glsl::vec3 slant_of(const StackPlanes& planes, const Direction& viewer, const Window& window);

/// render_stack_rows of a surface that all pixels see from one direction. A relief without depth, or a flat height map,
/// gives render_stack_rows exactly.
Image<V3f> render_relief_rows(const StackPlanes& planes, const ReliefPlanes& relief, const Direction& viewer,
                              const Window& window, int row_begin, int row_end);

/// The window with what was found before the exact path, as shaders/stack.frag
/// writes it.
Frame relief_frame(const StackPlanes& planes, const ReliefPlanes& relief, const Direction& viewer, const Window& window,
                   const ScaleView& view);

}  // namespace texbake
