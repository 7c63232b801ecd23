// Relief: where a slanted view ray meets the height field of a scale, and how the place is lit. Floating point, before
// the exact path: what follows is evaluated at the point that was found.
// Based on: Policarpo, Oliveira and Comba 2005, linear then binary search; Vanhoey et al. 2013, §7.
// Needs levels.glsl, what relief_bindings.glsl binds, and the scale of the heights in use; relief_level is the level of
// detail at which they are read.

// A place moved by 1/256 texels, within a few million.
Position moved_position(Position at, int dx, int dy) {
  int width = tile_size.x * 256;
  int height = tile_size.y * 256;
  int x = at.offset.x + dx;
  int y = at.offset.y + dy;
  int beyond_x = x >= 0 ? x / width : -((width - 1 - x) / width);
  int beyond_y = y >= 0 ? y / height : -((height - 1 - y) / height);
  Position moved;
  moved.tile = at.tile + uvec2(uint(beyond_x), uint(beyond_y));
  moved.offset = ivec2(x - beyond_x * width, y - beyond_y * height);
  return moved;
}

float height_at(Position at) { return level_value(height_plane, 3, height_levels, at, relief_level).x; }

// To the nearest 1/256 texel.
int rounded_256(float texels) { return int(floor(texels * 256.0f + 0.5f)); }

// The point of the ray at height `level`. `slope` is how far the ray moves, in texels, from height 1 to height 0; it
// crosses the plane that is drawn at `at`.
Position ray_point(Position at, vec2 slope, float level) {
  float fallen = relief_range.z - level;
  return moved_position(at, rounded_256(slope.x * fallen), rounded_256(slope.y * fallen));
}

// The height at which the ray through `at` first meets the surface, in at most `steps` and relief_steps.y further ones. A
// flat height field moves nothing.
float relief_height(Position at, vec2 slope, int steps) {
  float top = relief_range.x;
  float bottom = relief_range.y;
  if (top <= bottom || (slope.x == 0.0f && slope.y == 0.0f)) return relief_range.z;

  // Linear search, from the top: the first step that ends below the surface.
  float stride = (top - bottom) / float(steps);
  float above = top;
  float below_surface = bottom;
  for (int i = 1; i <= steps; ++i) {
    float level = i == steps ? bottom : top - stride * float(i);
    if (height_at(ray_point(at, slope, level)) >= level) {
      below_surface = level;
      break;
    }
    above = level;
  }
  // Binary search between the last point above the surface and the first below it.
  for (int i = 0; i < relief_steps.y; ++i) {
    float middle = (above + below_surface) * 0.5f;
    if (height_at(ray_point(at, slope, middle)) >= middle) below_surface = middle;
    else above = middle;
  }
  return below_surface;
}

Position relief_position(Position at, vec2 slope) {
  return ray_point(at, slope, relief_height(at, slope, relief_steps.x));
}

// How steep the surface is, to the right and downwards: rise in texels for a texel, where heights 0 to 1 are `depth`
// texels.
vec2 height_gradient(Position at, float depth) {
  float right = height_at(moved_position(at, 256, 0));
  float left = height_at(moved_position(at, -256, 0));
  float lower = height_at(moved_position(at, 0, 256));
  float upper = height_at(moved_position(at, 0, -256));
  return vec2((right - left) * 0.5f * depth, (lower - upper) * 0.5f * depth);
}

// The same from a normal map whose +y points up (`up` 1) or down (-1).
vec2 normal_gradient(vec4 normal, float up) {
  float z = normal.z > 0.0625f ? normal.z : 0.0625f;  // steeper than 86 degrees is noise
  return vec2(-normal.x / z, normal.y * up / z);
}

// Light from a direction that moves by light.xy, in texels, for a texel of height, over that on a flat surface: 1 where
// the surface is flat. light.z is the share of light from everywhere.
float shade(vec2 gradient, vec4 light) {
  float facing = 1.0f - gradient.x * light.x - gradient.y * light.y;
  float length_squared = 1.0f + gradient.x * gradient.x + gradient.y * gradient.y;
  float direct = facing > 0.0f ? facing / sqrt(length_squared) : 0.0f;
  return light.z + (1.0f - light.z) * direct;
}

// The same of the mean of many normals, not normalised: it is linear in them, so that the light on their mean is the mean
// of theirs, where none of them turns away. normal.z is in its w.
float shade_of_normals(vec4 relief, float up, vec4 light) {
  float facing = relief.w + relief.y * light.x - relief.z * up * light.y;
  return light.z + (1.0f - light.z) * (facing > 0.0f ? facing : 0.0f);
}
