// Windows of a stack seen aslant: parallax and light of the relief of its coarsest scale.
#pragma once

#include "libbake/eval/relief.h"
#include "libbake/eval/stack_window.h"

namespace texbake {

/// The colour that a ray from `viewer` through `at`, a point of `view.scale`, meets, and the light there. `program` is
/// that of the stack, with the relief bound.
glsl::vec4 relief_value(glsl::Program& program, const StackPlanes& planes, const Relief& relief,
                        const Direction& viewer, const ScaleView& view, const glsl::Position& at, Filter filter);

/// render_stack_rows of a surface that all pixels see from one direction. A relief without depth, or a flat height map,
/// gives render_stack_rows exactly.
Image<V3f> render_relief_rows(const StackPlanes& planes, const Relief& relief, const Direction& viewer,
                              const Window& window, int row_begin, int row_end);

}  // namespace texbake
