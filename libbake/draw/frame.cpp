#include "libbake/draw/frame.h"

#include "libbake/base/parallel.h"
#include "libbake/draw/window_program.h"

namespace texbake {
namespace {

using glsl::Position;
using glsl::Program;
using glsl::sampler2D;
using glsl::vec4;

/// A plane as the text takes it, and how it is filtered.
struct Drawn {
  sampler2D texels;
  int kind;
  sampler2D levels;
  Filter filter;
  int level_256;

  vec4 value(Program& program, const Position& at) const {
    if (filter == Filter::nearest) return program.texel_value(texels, kind, levels, program.texel_at(at));
    return program.trilinear_value(texels, kind, levels, at, level_256);
  }
};

}  // namespace

Frame reference_frame(const EvaluatorPlanes& planes, const Window& window, const Plane& plane) {
  check_window(window, planes.size);
  const Drawn drawn{sampler_of(plane.texels), plane_kind(plane.kind), sampler_of(plane.level_values), window.filter,
                    level_256_of(window, planes.level_count)};
  const glsl::Position origin = origin_of(window);
  const bool deformed = !window.deformation.is_identity() && &plane == &planes.base;
  Frame frame{Image<vec4>(window.width, window.height, {0, 0, 0, 0}),
              Image<PixelDecision>(window.width, window.height)};
  parallel_for(0, window.height, [&](int j) {
    Program program = program_of(planes, window);
    for (int i = 0; i < window.width; ++i) {
      const glsl::uvec2 pixel{static_cast<uint32_t>(i), static_cast<uint32_t>(j)};
      const glsl::Position at = program.pixel_position(origin, window.step_256, pixel);
      const glsl::Texel texel = program.texel_at(at);
      const glsl::Decision decision = program.decide(texel);
      const glsl::Source source = program.source_of(texel, decision);
      frame.decisions(i, j) = {static_cast<uint32_t>(decision.patch_idx), static_cast<uint32_t>(decision.content),
                               static_cast<uint32_t>(source.nearest.x), static_cast<uint32_t>(source.nearest.y)};
      if (deformed)
        frame.values(i, j) = program.deformed_value(drawn.texels, drawn.kind, drawn.levels, at,
                                                    smooth_filter(window.filter), drawn.level_256);
      else
        frame.values(i, j) = drawn.value(program, at);
    }
  });
  return frame;
}

}  // namespace texbake
