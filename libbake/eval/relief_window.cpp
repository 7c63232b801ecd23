#include "libbake/eval/relief_window.h"

#include "libbake/base/parallel.h"
#include "libbake/eval/program_of.h"

namespace texbake {

glsl::vec4 relief_value(glsl::Program& program, const StackPlanes& planes, const Relief& relief,
                        const Direction& viewer, const ScaleView& view, const glsl::Position& at, Filter filter) {
  // The relief is that of the coarsest scale: down to it, along the ray, and the same way further in the scale that
  // shows.
  glsl::Position outer = at;
  int ratio = 1;
  for (int scale = view.scale; scale > 0; --scale) {
    program.use_scale(scale);
    outer = program.coarser_position(scale, outer);
    ratio *= planes.transfers[static_cast<size_t>(scale)].ratio;
  }
  program.use_scale(0);
  const glsl::Position met = relief.met(program, outer, viewer);
  const float light = relief.light_at(program, met);
  program.use_scale(view.scale);
  const glsl::Position shown = moved_alike(program, outer, met, planes.sizes[0], at, ratio);
  const int smooth = filter == Filter::nearest ? 0 : 1;
  return program.stack_probes_value(stack_probes(view, shown), smooth) * light;
}

Image<V3f> render_relief_rows(const StackPlanes& planes, const Relief& relief, const Direction& viewer,
                              const Window& window, int row_begin, int row_end) {
  const ScaleView view = scale_view(planes, window);
  const Window shown = window_in_scale(planes, window, view.scale);
  check_window(shown, planes.sizes[static_cast<size_t>(view.scale)]);
  glsl::Program bound = program_of(planes, shown.seed, reference_near(planes, shown, view.scale));
  relief.bind(bound);
  Image<V3f> rows(shown.width, row_end - row_begin);
  parallel_for(0, rows.height(), [&](int j) {
    glsl::Program program = bound;
    for (int i = 0; i < rows.width(); ++i) {
      program.use_scale(view.scale);
      const glsl::Position at = program.pixel_position(
          origin_of(shown), shown.step_256, {static_cast<uint32_t>(i), static_cast<uint32_t>(row_begin + j)});
      const glsl::vec4 value = relief_value(program, planes, relief, viewer, view, at, window.filter);
      rows(i, j) = {value.x, value.y, value.z};
    }
  });
  return rows;
}

}  // namespace texbake
