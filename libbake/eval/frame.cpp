#include "libbake/eval/frame.h"

#include "libbake/base/parallel.h"
#include "libbake/eval/program_of.h"

namespace texbake {
namespace {

using glsl::Footprint;
using glsl::Program;
using glsl::sampler2D;
using glsl::Source;
using glsl::vec4;

vec4 nearest_value(Program& program, const sampler2D& plane, MapKind kind, const glsl::Texel& texel,
                   const Source& source) {
  switch (kind) {
    case MapKind::normal_opengl:
      return program.source_normal(plane, source, 1.0f);
    case MapKind::normal_directx:
      return program.source_normal(plane, source, -1.0f);
    case MapKind::height:
      return program.source_height(plane, source);
    case MapKind::structure:
      return program.layered_value(plane, texel, source);
    case MapKind::plain:
      break;
  }
  return program.source_value(plane, source);
}

vec4 blended_value(Program& program, const sampler2D& plane, MapKind kind, const glsl::Position& at) {
  const Footprint footprint = program.footprint_at(at);
  switch (kind) {
    case MapKind::normal_opengl:
      return program.footprint_normal(plane, footprint, 1.0f);
    case MapKind::normal_directx:
      return program.footprint_normal(plane, footprint, -1.0f);
    case MapKind::height:
      return program.footprint_height(plane, footprint);
    case MapKind::structure:
      return program.footprint_layers(plane, footprint, at);
    case MapKind::plain:
      break;
  }
  return program.footprint_value(plane, footprint);
}

}  // namespace

Frame reference_frame(const EvaluatorPlanes& planes, const Window& window, const Plane& plane) {
  check_window(window, planes.size);
  const sampler2D sampler = sampler_of(plane.texels);
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
      const Source source = program.source_of(texel, decision);
      frame.decisions(i, j) = {static_cast<uint32_t>(decision.patch_idx), static_cast<uint32_t>(decision.content),
                               static_cast<uint32_t>(source.nearest.x), static_cast<uint32_t>(source.nearest.y)};
      if (deformed) {
        frame.values(i, j) = window.filter == Filter::nearest ? program.deformed_value(sampler, texel)
                                                              : program.deformed_footprint(sampler, at);
        continue;
      }
      frame.values(i, j) = window.filter == Filter::nearest ? nearest_value(program, sampler, plane.kind, texel, source)
                                                            : blended_value(program, sampler, plane.kind, at);
    }
  });
  return frame;
}

}  // namespace texbake
