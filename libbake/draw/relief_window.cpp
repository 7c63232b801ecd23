#include "libbake/draw/relief_window.h"

#include "libbake/base/parallel.h"
#include "libbake/draw/window_program.h"
#include "libbake/reference/stack_row_program.h"

namespace texbake {
namespace {

/// Calls draw(program, i, j, sight) for every pixel of rows `row_begin` + j, with a Text of each row: Program, or what
/// differs from it in time.
template <class Text, class Draw>
void for_each_sight(const StackPlanes& planes, const ReliefPlanes& relief, const Direction& viewer,
                    const Window& window, const ScaleView& view, int row_begin, int row_end, const Draw& draw) {
  glsl::Program bound = window_program_of(planes, window);
  bind_relief(bound, relief);
  const glsl::vec3 slant = slant_of(planes, viewer, window);
  parallel_for(0, row_end - row_begin, [&](int j) {
    Text program(bound);
    for (int i = 0; i < window.width; ++i) {
      const glsl::Position at = stack_pixel_position(program, window, view.scale, i, row_begin + j);
      draw(program, i, j, program.window_sight(stack_probes(view, at), slant));
    }
  });
}

}  // namespace

glsl::vec3 slant_of(const StackPlanes& planes, const Direction& viewer, const Window& window) {
  const auto texels = static_cast<double>(planes.texels_in(0));
  return {-viewer.x / viewer.z, -viewer.y / viewer.z, static_cast<float>(window.step_256 / (256 * texels))};
}

Image<V3f> render_relief_rows(const StackPlanes& planes, const ReliefPlanes& relief, const Direction& viewer,
                              const Window& window, int row_begin, int row_end) {
  const ScaleView view = scale_view(planes, window);
  Image<V3f> rows(window.width, row_end - row_begin);
  for_each_sight<glsl::StackRowProgram>(
      planes, relief, viewer, window, view, row_begin, row_end,
      [&](glsl::StackRowProgram& program, int i, int j, const glsl::StackSight& sight) {
        const glsl::vec4 value = program.sight_value(sight, smooth_filter(window.filter));
        rows(i, j) = {value.x, value.y, value.z};
      });
  return rows;
}

Frame relief_frame(const StackPlanes& planes, const ReliefPlanes& relief, const Direction& viewer, const Window& window,
                   const ScaleView& view) {
  Frame frame{Image<glsl::vec4>(window.width, window.height, {0, 0, 0, 0}),
              Image<PixelDecision>(window.width, window.height)};
  for_each_sight<glsl::Program>(planes, relief, viewer, window, view, 0, window.height,
                                [&](glsl::Program& program, int i, int j, const glsl::StackSight& sight) {
                                  const glsl::uvec4 decided = program.decided_of(sight);
                                  frame.values(i, j) = program.sight_value(sight, smooth_filter(window.filter));
                                  frame.decisions(i, j) = {decided.x, decided.y, decided.z, decided.w};
                                });
  return frame;
}

}  // namespace texbake
