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
using glsl::uvec2;

Position pixel_point(Program& program, const Window& window, int scale, int i, int j) {
  program.use_scale(scale);
  return program.pixel_position(origin_of(window), window.step_256,
                                {static_cast<uint32_t>(i), static_cast<uint32_t>(j)});
}

}  // namespace

glsl::uvec2 reference_near(const StackPlanes& planes, const Window& window, int scale) {
  // Outwards from a coarser scale: the repetition of the next finer one in which its tile's corner lies.
  int64_t x = static_cast<int32_t>(window.origin_x.tile), y = static_cast<int32_t>(window.origin_y.tile);
  for (int s = scale + 1; s <= planes.finest(); ++s) {
    const auto at = static_cast<size_t>(s);
    x = x * planes.sizes[at - 1].x * planes.transfers[at].ratio / planes.sizes[at].x;
    y = y * planes.sizes[at - 1].y * planes.transfers[at].ratio / planes.sizes[at].y;
  }
  return {static_cast<uint32_t>(x), static_cast<uint32_t>(y)};
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
  view.level_256 = level_256_of(window_in_scale(planes, window, view.scale), planes.level_count(view.scale));
  // A scale that fades has no mean of its own beyond its last level.
  if (view.scale > 0) view.level_256 = std::min(view.level_256, 256 * planes.level_count(view.scale));
  return view;
}

glsl::StackProbes stack_probes(const ScaleView& view, const Position& at) {
  return {{at, {0, 0}, 0, view.level_256}, view.scale, 0, view.fading, view.variation};
}

Window window_in_scale(const StackPlanes& planes, const Window& window, int scale) {
  const int64_t texels = planes.texels_in(scale);
  if (texels == 1) return window;
  const V2i fine = planes.sizes.back(), size = planes.sizes[static_cast<size_t>(scale)];
  const auto moved = [&](const TileOffset& at, int fine_side, int side) {
    // The place in 1/256 texels of the finest scale needs more than 64 bits: whole tiles first.
    const int64_t left = int64_t{static_cast<int32_t>(at.tile)} * fine_side;
    const int64_t whole = left / texels - (left % texels < 0 ? 1 : 0);
    const int64_t rest_256 = (left - whole * texels) * 256 + at.offset_256;
    return tile_offset(whole, rest_256 / texels, side);
  };
  Window coarse = window;
  coarse.origin_x = moved(window.origin_x, fine.x, size.x);
  coarse.origin_y = moved(window.origin_y, fine.y, size.y);
  coarse.step_256 = static_cast<uint32_t>(std::max<int64_t>(1, (window.step_256 + texels / 2) / texels));
  return coarse;
}

Image<V3f> render_scale_rows(const StackPlanes& planes, const Window& window, const ScaleView& view, int row_begin,
                             int row_end) {
  check_window(window, planes.sizes[static_cast<size_t>(view.scale)]);
  Image<V3f> rows(window.width, row_end - row_begin);
  const Program bound = program_of(planes, window.seed, reference_near(planes, window, view.scale));
  for_each_row(bound, rows.height(), [&](StackRowProgram& program, int j) {
    for (int i = 0; i < rows.width(); ++i) {
      const Position at = pixel_point(program, window, view.scale, i, row_begin + j);
      const glsl::vec4 value = program.stack_probes_value(stack_probes(view, at), smooth_filter(window.filter));
      rows(i, j) = {value.x, value.y, value.z};
    }
  });
  return rows;
}

Image<V3f> render_stack_rows(const StackPlanes& planes, const Window& window, int row_begin, int row_end) {
  const ScaleView view = scale_view(planes, window);
  return render_scale_rows(planes, window_in_scale(planes, window, view.scale), view, row_begin, row_end);
}

Frame reference_stack_frame(const StackPlanes& planes, const Window& window, const ScaleView& view) {
  check_window(window, planes.sizes[static_cast<size_t>(view.scale)]);
  Frame frame{Image<glsl::vec4>(window.width, window.height, {0, 0, 0, 0}),
              Image<PixelDecision>(window.width, window.height)};
  const Program bound = program_of(planes, window.seed, reference_near(planes, window, view.scale));
  parallel_for(0, window.height, [&](int j) {
    Program program = bound;
    for (int i = 0; i < window.width; ++i) {
      const Position at = pixel_point(program, window, view.scale, i, j);
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
