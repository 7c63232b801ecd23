// Relief of the coarsest scale: how far the ray of a pixel moves what it sees, and the light there. Floating point, before
// the exact path; it ends in integers (StackSight).
// Needs relief.glsl, stack_levels.glsl and what relief_bindings.glsl binds.

// What a pixel sees: points in a row, all at one level of `scale`, and how far that has faded into the scale before it.
struct StackProbes {
  Probes row;             // of `scale`; level_256: 0 ... 256 (level_count + 1)
  int scale;
  int coarser_halvings;   // 2^coarser_halvings points of the scale before it, whose texels are larger
  float fading;           // 0 ... 1
  float variation;        // share of its variation that `scale` still has
};

struct StackSight {
  bool hits;
  StackProbes seen;
  int light_4096;  // 4096 times the light on it
};

float within(float x, float least, float most) { return x < least ? least : x > most ? most : x; }

// What is left of the parallax where a pixel is `width` texels of the coarsest scale wide: all where the whole relief is
// two pixels deep, nothing where it is one.
float parallax_left(float width) {
  return within(relief_depth * (relief_range.x - relief_range.y) / width - 1.0f, 0.0f, 1.0f);
}

// How relief moves and lights what is seen at a point.
struct Relieved {
  vec2 moved;      // texels of the coarsest scale
  int light_4096;
};

// `pixel` is what is seen without relief: points of the coarsest scale, each `width` texels wide, its level left open. `way` is that of the ray, to the
// right and down, for each texel that it falls.
Relieved relief_at(Probes pixel, vec2 way, float width) {
  float depth = relief_depth * parallax_left(width);
  vec2 slope = vec2(within(way.x * depth, -2048.0f, 2048.0f), within(way.y * depth, -2048.0f, 2048.0f));
  // Two steps to a texel, or to a pixel where that is larger.
  float passed = sqrt(sum_of_squares(slope.x, slope.y)) * (relief_range.x - relief_range.y);
  float wanted = passed * 2.0f / (width < 1.0f ? 1.0f : width) + 1.0f;
  int steps = wanted < float(relief_steps.x) ? int(wanted) : relief_steps.x;
  int level_256 = log2_256(width);
  use_scale(0);
  use_levels(0);
  value_row = 0;
  relief_level = level_256 < 0 ? 0 : level_256 >> 8;
  float fallen = relief_range.z - relief_height(pixel.at, slope, steps);

  Relieved relieved;
  relieved.moved = vec2(slope.x * fallen, slope.y * fallen);
  relieved.light_4096 = 4096;
  if (relief_kind == kUnlit) return relieved;

  // The light on the mean of the normals that the pixel's probes see.
  int last_256 = 256 * (level_count + 1);
  Probes probes = pixel;
  probes.at = moved_position(pixel.at, ivec2(rounded_256(relieved.moved.x), rounded_256(relieved.moved.y)));
  probes.level_256 = level_256 < 0 ? 0 : level_256 > last_256 ? last_256 : level_256;
  vec4 mean = probes_value(height_plane, relief_kind, height_levels, probes);
  relieved.light_4096 = int(shade_of_normals(mean, relief_kind == kPlaneReliefOpengl ? 1.0f : -1.0f, relief_light) * 4096.0f + 0.5f);
  return relieved;
}

// What is seen without relief, moved and lit: a finer scale moves by as many texels of the coarsest.
StackSight moved_and_lit(StackSight flat_sight, Relieved relieved) {
  StackSight sight = flat_sight;
  float finer = texels_in(0) / texels_in(sight.seen.scale);
  use_scale(sight.seen.scale);
  sight.seen.row.at = moved_position(sight.seen.row.at, ivec2(rounded_256(relieved.moved.x * finer), rounded_256(relieved.moved.y * finer)));
  sight.light_4096 = relieved.light_4096;
  return sight;
}

// The same for a pixel of a window, all of which look in one direction: `leaning` is the way of their rays, to the right and
// down, for each texel that they fall, and the width of a pixel in texels of the coarsest scale.
StackSight window_sight(StackProbes seen, vec3 leaning) {
  StackSight sight;
  sight.hits = true;
  sight.seen = seen;
  sight.light_4096 = 4096;
  if (relief_depth == 0.0f) return sight;
  Probes pixel = seen.row;
  pixel.at = position_in_scale(seen.row.at, seen.scale, 0);
  return moved_and_lit(sight, relief_at(pixel, vec2(leaning.x, leaning.y), leaning.z));
}

// What was found, in numbers to compare: offset of the middle, their upper bits 256 fading and 256 variation; level_256 |
// (halvings + 1) << 16 | coarser_halvings << 20 | scale << 24; axis, 16 bits of each part, stirred by the light.
uvec4 decided_of(StackSight sight) {
  StackProbes seen = sight.seen;
  Probes row = seen.row;
  uint light = uint(sight.light_4096 - 4096) * 2654435769u;
  return uvec4(uint(row.at.offset.x) | uint(seen.fading * 256.0f) << 22u, uint(row.at.offset.y) | uint(seen.variation * 256.0f) << 22u,
               uint(row.level_256) | (uint(row.halvings) + 1u) << 16u | uint(seen.coarser_halvings) << 20u | uint(seen.scale) << 24u,
               ((uint(row.axis_256.x) & 65535u) | uint(row.axis_256.y) << 16u) + light);
}
