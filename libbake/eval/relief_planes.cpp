#include "libbake/eval/relief_planes.h"

#include <cmath>

#include "libbake/base/torus.h"
#include "libbake/eval/levels.h"
#include "libbake/eval/program_of.h"

namespace texbake {
namespace {

/// +y up.
V3f normal_of_heights(const Image<glsl::vec4>& heights, V2i p, float depth_px) {
  const auto at = [&](int x, int y) { return heights(wrap(x, heights.width()), wrap(y, heights.height())).x; };
  const float right = (at(p.x + 1, p.y) - at(p.x - 1, p.y)) * 0.5f * depth_px;
  const float down = (at(p.x, p.y + 1) - at(p.x, p.y - 1)) * 0.5f * depth_px;
  const float length = std::sqrt(1 + right * right + down * down);
  return V3f(-right, down, 1) / length;
}

Image<glsl::vec4> heights_and_normals(const Relief& relief) {
  const Image<glsl::vec4>& heights = relief.height().texels;
  const bool by_normal = relief.options().shade_by == ShadeBy::normal;
  Image<glsl::vec4> both(heights.width(), heights.height(), {0, 0, 0, 0});
  for (int y = 0; y < both.height(); ++y)
    for (int x = 0; x < both.width(); ++x) {
      V3f normal = by_normal ? V3f(0) : normal_of_heights(heights, {x, y}, relief.options().depth_px);
      if (by_normal) {
        const glsl::vec4& n = relief.normal()->texels(x, y);
        normal = V3f(n.x, n.y, n.z);
      }
      both(x, y) = {heights(x, y).x, normal.x, normal.y, normal.z};
    }
  return both;
}

}  // namespace

ReliefPlanes relief_planes(const EvaluatorInput& coarsest, const ReliefOptions& options, const Direction& light) {
  EvaluatorInput input = coarsest;
  input.noise.reset();
  input.soft_border_px = 0;
  EvaluatorPlanes planes = prepare(input);
  ReliefPlanes bound;
  MapKind kind = MapKind::relief_opengl;
  {
    const Relief relief(planes, options, light);
    if (options.shade_by == ShadeBy::normal && relief.normal()->kind == MapKind::normal_directx)
      kind = MapKind::relief_directx;
    bound.range = relief.range();
    bound.light = relief.light();
    bound.height_plane = heights_and_normals(relief);
  }
  bound.steps = {options.linear_steps, options.binary_steps};
  bound.depth_px = options.depth_px;
  bound.kind = options.shade_by == ShadeBy::none ? 0 : plane_kind(kind);

  planes.maps.clear();
  planes.maps.push_back({"relief", kind, 4, std::move(bound.height_plane)});
  add_levels(planes, planes.maps[0]);
  bound.height_plane = std::move(planes.maps[0].texels);
  bound.height_levels = std::move(planes.maps[0].level_values);
  return bound;
}

void bind_relief(glsl::Program& program, const ReliefPlanes& relief) {
  program.height_plane = sampler_of(relief.height_plane);
  program.height_levels = sampler_of(relief.height_levels);
  program.relief_range = relief.range;
  program.relief_steps = relief.steps;
  program.relief_depth = relief.depth_px;
  program.relief_light = relief.light;
  program.relief_kind = relief.kind;
}

}  // namespace texbake
