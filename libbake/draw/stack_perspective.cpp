#include "libbake/draw/stack_perspective.h"

#include "libbake/base/parallel.h"
#include "libbake/draw/relief_window.h"
#include "libbake/draw/view_program.h"
#include "libbake/reference/stack_row_program.h"

namespace texbake {
namespace {

using glsl::PerspectiveProgram;
using glsl::StackRowProgram;
using glsl::StackSight;
using glsl::vec4;

PerspectiveProgram bound(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view) {
  check_perspective(view, planes.sizes.back());
  glsl::Program program = program_of(planes, view.seed, {view.origin_x.tile, view.origin_y.tile});
  if (relief) bind_relief(program, *relief);
  return with_view(program, view);
}

StackSight sight_of(PerspectiveProgram& program, const Perspective& view, int x, int y) {
  return program.stack_sight_at(point_below(view), static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
}

V3f color_of(const vec4& value) { return {value.x, value.y, value.z}; }

/// Calls draw(program, values, x, y) for every pixel of the rows: `program` finds what is seen, `values` what that
/// shows.
template <class Draw>
Image<V3f> draw_rows(const PerspectiveProgram& shared, const Perspective& view, int row_begin, int row_end,
                     const Draw& draw) {
  Image<V3f> rows(view.width, row_end - row_begin);
  for_each_row(shared, rows.height(), [&](StackRowProgram& values, int j) {
    PerspectiveProgram program = shared;
    for (int i = 0; i < rows.width(); ++i) rows(i, j) = draw(program, values, i, row_begin + j);
  });
  return rows;
}

}  // namespace

Image<V3f> render_stack_perspective_rows(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view,
                                         int row_begin, int row_end) {
  return draw_rows(bound(planes, relief, view), view, row_begin, row_end,
                   [&](PerspectiveProgram& program, StackRowProgram& values, int x, int y) {
                     const StackSight sight = sight_of(program, view, x, y);
                     return sight.hits ? color_of(values.sight_value(sight, program.view_filter)) : view.sky;
                   });
}

Image<V3f> supersampled_stack_perspective_rows(const StackPlanes& planes, const ReliefPlanes* relief,
                                               const Perspective& view, int samples, int row_begin, int row_end) {
  const auto place = [&](int pixel, int k) {
    return static_cast<float>(pixel) + (static_cast<float>(k) + 0.5f) / static_cast<float>(samples);
  };
  return draw_rows(
      bound(planes, relief, view), view, row_begin, row_end,
      [&](PerspectiveProgram& program, StackRowProgram& values, int x, int y) {
        // The scales that the whole pixel sees, of each sample's place alone.
        StackSight sight = sight_of(program, view, x, y);
        sight.seen.row.level_256 = sight.seen.row.halvings = sight.seen.coarser_halvings = 0;
        Imath::V3d sum(0);
        for (int l = 0; l < samples; ++l)
          for (int k = 0; k < samples; ++k) {
            const auto ground = program.ground_at(place(x, k), place(y, l));
            if (ground.hits) sight.seen.row.at = program.stack_position(point_below(view), ground.to, sight.seen.scale);
            const PerspectiveProgram::Ellipse point{
                kPointWidth, kPointWidth, {kPointWidth, 0}, kPointWidth * kPointWidth};
            const StackSight seen =
                ground.hits ? program.with_relief(sight, point_below(view), ground, point, kPointWidth) : sight;
            sum += Imath::V3d(ground.hits ? color_of(values.sight_value(seen, program.view_filter)) : view.sky);
          }
        return V3f(sum / (double{1} * samples * samples));
      });
}

Frame stack_perspective_frame(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view) {
  const PerspectiveProgram shared = bound(planes, relief, view);
  Frame frame{Image<vec4>(view.width, view.height, {view.sky.x, view.sky.y, view.sky.z, 0}),
              Image<PixelDecision>(view.width, view.height)};
  parallel_for(0, view.height, [&](int y) {
    PerspectiveProgram program = shared;
    for (int x = 0; x < view.width; ++x) {
      const StackSight sight = sight_of(program, view, x, y);
      if (!sight.hits) continue;
      const glsl::uvec4 decided = program.decided_of(sight);
      frame.values(x, y) = program.sight_value(sight, program.view_filter);
      frame.decisions(x, y) = {decided.x, decided.y, decided.z, decided.w};
    }
  });
  return frame;
}

}  // namespace texbake
