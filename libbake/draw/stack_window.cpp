#include "libbake/draw/stack_window.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/draw/window_program.h"
#include "libbake/reference/stack_row_program.h"

namespace texbake {
namespace {

using glsl::Position;
using glsl::Program;
using glsl::StackRowProgram;

}  // namespace

glsl::Position stack_pixel_position(Program& program, const Window& window, int scale, int i, int j) {
  const int finest = program.scale_count - 1;
  program.use_scale(finest);
  const glsl::uvec2 pixel{static_cast<uint32_t>(i), static_cast<uint32_t>(j)};
  return program.position_in_scale(program.pixel_position(origin_of(window), window.step_256, pixel), finest, scale);
}

Program window_program_of(const StackPlanes& planes, const Window& window) {
  check_window(window, planes.sizes.back());
  return program_of(planes, window.seed, {window.origin_x.tile, window.origin_y.tile});
}

ScaleView scale_view(const StackPlanes& planes, double texels) {
  ScaleView view{planes.finest(), 0, 1};
  while (view.scale > 0) {
    const ScaleTransfer& transfer = planes.transfers[static_cast<size_t>(view.scale)];
    if (texels < transfer.ratio) break;
    texels /= transfer.ratio;
    --view.scale;
  }
  if (view.scale == 0 || texels <= 1) return view;
  const ScaleTransfer& transfer = planes.transfers[static_cast<size_t>(view.scale)];
  view.fading = static_cast<float>(portable_log(texels) / portable_log(transfer.ratio));
  view.variation = std::max(0.0f, 1.0f - transfer.variation_fade * view.fading);
  return view;
}

ScaleView scale_view(const StackPlanes& planes, const Window& window) {
  ScaleView view = scale_view(planes, window.step_256 / 256.0);
  const double texels = window.step_256 / (256.0 * static_cast<double>(planes.texels_in(view.scale)));
  view.level_256 = level_256_of(texels, window.filter, planes.level_count(view.scale));
  // A scale that fades has no mean of its own beyond its last level.
  if (view.scale > 0) view.level_256 = std::min(view.level_256, 256 * planes.level_count(view.scale));
  return view;
}

glsl::StackProbes stack_probes(const ScaleView& view, const Position& at) {
  return {{at, {0, 0}, 0, view.level_256}, view.scale, 0, view.fading, view.variation};
}

Image<V3f> render_scale_rows(const StackPlanes& planes, const Window& window, const ScaleView& view, int row_begin,
                             int row_end) {
  const Program bound = window_program_of(planes, window);
  Image<V3f> rows(window.width, row_end - row_begin);
  for_each_row(bound, rows.height(), [&](StackRowProgram& program, int j) {
    for (int i = 0; i < rows.width(); ++i) {
      const Position at = stack_pixel_position(program, window, view.scale, i, row_begin + j);
      const glsl::vec4 value = program.stack_probes_value(stack_probes(view, at), smooth_filter(window.filter));
      rows(i, j) = {value.x, value.y, value.z};
    }
  });
  return rows;
}

Image<V3f> render_stack_rows(const StackPlanes& planes, const Window& window, int row_begin, int row_end) {
  return render_scale_rows(planes, window, scale_view(planes, window), row_begin, row_end);
}

Frame reference_stack_frame(const StackPlanes& planes, const Window& window, const ScaleView& view) {
  const Program bound = window_program_of(planes, window);
  Frame frame{Image<glsl::vec4>(window.width, window.height, {0, 0, 0, 0}),
              Image<PixelDecision>(window.width, window.height)};
  parallel_for(0, window.height, [&](int j) {
    Program program = bound;
    for (int i = 0; i < window.width; ++i) {
      const Position at = stack_pixel_position(program, window, view.scale, i, j);
      const glsl::Texel texel = program.texel_at(at);
      const glsl::Decision decision = program.decide(texel);
      const glsl::Source source = program.source_of(texel, decision);
      frame.decisions(i, j) = {static_cast<uint32_t>(decision.patch_idx), static_cast<uint32_t>(decision.content),
                               static_cast<uint32_t>(source.nearest.x), static_cast<uint32_t>(source.nearest.y)};
      frame.values(i, j) = program.stack_probes_value(stack_probes(view, at), smooth_filter(window.filter));
    }
  });
  return frame;
}

}  // namespace texbake
