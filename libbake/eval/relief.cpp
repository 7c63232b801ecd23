#include "libbake/eval/relief.h"

#include <fmt/format.h>

#include <algorithm>

#include "libbake/base/error.h"
#include "libbake/eval/program_of.h"

namespace texbake {
namespace {

/// Least, greatest and mean height that contents can show: relief shrinks with them.
glsl::vec4 range_of(const EvaluatorPlanes& planes, const Plane& height) {
  float least = height.texels(0, 0).x, most = least;
  double sum = 0;
  for (const glsl::vec4& texel : height.texels) {
    least = std::min(least, texel.x);
    most = std::max(most, texel.x);
    sum += texel.x;
  }
  float smallest_scale = 1;
  for (const glsl::ivec4& content : planes.contents)
    smallest_scale = std::min(smallest_scale, static_cast<float>(content.y) / 65536);
  return {most, least * smallest_scale, static_cast<float>(sum / static_cast<double>(height.texels.size())), 0};
}

}  // namespace

Relief::Relief(const EvaluatorPlanes& planes, const ReliefOptions& options, const Direction& light)
    : options_(options), height_(planes.map("height")) {
  if (!height_)
    throw Error(ErrorKind::usage,
                "--relief: expected a height map in the coarsest scale, found none; give convert --map height=FILE, or "
                "make one with \"texbake heightmap\"");
  for (const Plane& map : planes.maps)
    if (map.kind == MapKind::normal_opengl || map.kind == MapKind::normal_directx) normal_ = &map;
  if (options.shade_by == ShadeBy::normal && !normal_)
    throw Error(ErrorKind::usage,
                "--shade normal: expected a normal map in the coarsest scale, found none; use --shade height");
  if (!(light.z > 0))
    throw Error(ErrorKind::usage,
                fmt::format("--light: expected a direction from above (z > 0), found z = {}", light.z));
  range_ = range_of(planes, *height_);
  light_ = {light.x / light.z, light.y / light.z, options.ambient, 0};
}

void Relief::bind(glsl::Program& program) const {
  program.height_plane = sampler_of(height_->texels);
  program.height_levels = sampler_of(height_->level_values);
  program.relief_range = range_;
  program.relief_steps = {options_.linear_steps, options_.binary_steps};
}

glsl::Position Relief::met(glsl::Program& program, const glsl::Position& at, const Direction& viewer) const {
  // Away from the viewer as the ray falls.
  const float per_height = options_.depth_px / viewer.z;
  return program.relief_position(at, {-viewer.x * per_height, -viewer.y * per_height});
}

float Relief::light_at(glsl::Program& program, const glsl::Position& at) const {
  if (options_.shade_by == ShadeBy::none || options_.depth_px == 0) return 1;
  if (options_.shade_by == ShadeBy::height)
    return program.shade(program.height_gradient(at, options_.depth_px), light_);
  const float up = normal_->kind == MapKind::normal_opengl ? 1.0f : -1.0f;
  const glsl::vec4 normal = program.footprint_normal(sampler_of(normal_->texels), program.footprint_at(at), up);
  return program.shade(program.normal_gradient(normal, up), light_);
}

glsl::Position moved_alike(glsl::Program& program, const glsl::Position& from, const glsl::Position& to, V2i size,
                           const glsl::Position& at, int ratio) {
  const int dx = (static_cast<int>(to.tile.x - from.tile.x) * size.x * 256 + to.offset.x - from.offset.x) * ratio;
  const int dy = (static_cast<int>(to.tile.y - from.tile.y) * size.y * 256 + to.offset.y - from.offset.y) * ratio;
  return program.moved_position(at, dx, dy);
}

}  // namespace texbake
