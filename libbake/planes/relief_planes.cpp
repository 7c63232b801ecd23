#include "libbake/planes/relief_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/error.h"
#include "libbake/base/torus.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/program_of.h"

namespace texbake {
namespace {

const Plane& heights_of(const TilePlanes& planes) {
  if (const Plane* heights = planes.map("height")) return *heights;
  throw Error(ErrorKind::usage,
              "--relief: expected a height map in the coarsest scale, found none; pass --map height=FILE to convert, "
              "or make one with \"texbake heightmap\"");
}

const Plane& normals_of(const TilePlanes& planes) {
  for (const Plane& map : planes.maps)
    if (map.kind == MapKind::normal_opengl || map.kind == MapKind::normal_directx) return map;
  throw Error(ErrorKind::usage,
              "--shade normal: expected a normal map in the coarsest scale, found none; use --shade height");
}

void check_light(const Direction& light) {
  if (!(light.z > 0))
    throw Error(ErrorKind::usage,
                fmt::format("--light: expected a direction from above (z > 0), found z = {}", light.z));
}

/// Greatest, least and mean height that contents can show: relief shrinks with them.
glsl::vec4 range_of(const TilePlanes& planes, const Plane& height) {
  float least = height.texels(0, 0).x, most = least;
  double sum = 0;
  for (const glsl::vec4& texel : height.texels) {
    least = std::min(least, texel.x);
    most = std::max(most, texel.x);
    sum += double{texel.x};
  }
  float smallest_scale = 1;
  for (const glsl::ivec4& content : planes.contents)
    smallest_scale = std::min(smallest_scale, static_cast<float>(content.y) / 65536);
  return {most, least * smallest_scale, static_cast<float>(sum / static_cast<double>(height.texels.size())), 0};
}

/// +y up.
V3f normal_of_heights(const Image<glsl::vec4>& heights, V2i p, float depth_px) {
  const auto at = [&](int x, int y) { return heights(wrap(x, heights.width()), wrap(y, heights.height())).x; };
  const float right = (at(p.x + 1, p.y) - at(p.x - 1, p.y)) * 0.5f * depth_px;
  const float down = (at(p.x, p.y + 1) - at(p.x, p.y - 1)) * 0.5f * depth_px;
  const float length = std::sqrt(1 + right * right + down * down);
  return V3f(-right, down, 1) / length;
}

/// `normals` are the material's; those of the heights where it is nullptr.
Image<glsl::vec4> heights_and_normals(const Image<glsl::vec4>& heights, const Plane* normals, float depth_px) {
  Image<glsl::vec4> both(heights.width(), heights.height(), {0, 0, 0, 0});
  for (int y = 0; y < both.height(); ++y)
    for (int x = 0; x < both.width(); ++x) {
      V3f normal = normals ? V3f(0) : normal_of_heights(heights, {x, y}, depth_px);
      if (normals) {
        const glsl::vec4& n = normals->texels(x, y);
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
  const TilePlanes planes = prepare_tile(input);
  const Plane& heights = heights_of(planes);
  const Plane* const normals = options.shade_by == ShadeBy::normal ? &normals_of(planes) : nullptr;
  check_light(light);
  const bool is_directx = normals && normals->kind == MapKind::normal_directx;
  const MapKind kind = is_directx ? MapKind::relief_directx : MapKind::relief_opengl;
  ReliefPlanes bound;
  bound.relief_range = range_of(planes, heights);
  bound.relief_light = {light.x / light.z, light.y / light.z, options.ambient, 0};
  bound.relief_steps = {options.linear_steps, options.binary_steps};
  bound.relief_depth = options.depth_px;
  bound.relief_kind = options.shade_by == ShadeBy::none ? glsl::kUnlit : plane_kind(kind);

  Plane relief{"relief", kind, 4, heights_and_normals(heights.texels, normals, options.depth_px)};
  bound.height_levels = level_values(level_lists(planes), relief, planes);
  bound.height_plane = std::move(relief.texels);
  return bound;
}

void bind_relief(glsl::Program& program, const ReliefPlanes& relief) {
  for_each_texture(relief, sampler_binder(program));
  bind_uniforms<glsl::ReliefUniforms>(relief, program);
}

}  // namespace texbake
