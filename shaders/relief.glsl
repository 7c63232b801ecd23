// Relief: where a slanted view ray meets the height field of a scale, and how the place is lit. Floating point, before
// the exact path: what follows is evaluated at the point that was found.
// Based on: Policarpo, Oliveira and Comba 2005, linear then binary search; Vanhoey et al. 2013, §7.
// Needs levels.glsl, what relief_bindings.glsl binds, and the scale of the heights in use; relief_level is the level of
// detail at which they are read.

float height_at(Position at) { return level_value(height_plane, kPlaneHeight, height_levels, at, relief_level).x; }

// To the nearest 1/256 texel.
int rounded_256(float texels) { return int(floor(texels * 256.0f + 0.5f)); }

// The point of the ray at height `level`. `slope` is how far the ray moves, in texels, from height 1 to height 0; it
// crosses the plane that is drawn at `at`.
Position ray_point(Position at, vec2 slope, float level) {
  float fallen = relief_range.z - level;
  return moved_position(at, ivec2(rounded_256(slope.x * fallen), rounded_256(slope.y * fallen)));
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

// Light from a direction that moves by light.xy, in texels, for a texel of height, on the mean of some normals, which is
// not normalized: it is linear in them, so that the light on their mean is the mean of theirs, where none of them turns
// away. On a flat surface it is 1. light.z is the share of light from everywhere; `up` is 1 where +y of the normals points
// up, else -1; normal.z is in relief.w.
float shade_of_normals(vec4 relief, float up, vec4 light) {
  float facing = relief.w + relief.y * light.x - relief.z * up * light.y;
  return light.z + (1.0f - light.z) * (facing > 0.0f ? facing : 0.0f);
}
