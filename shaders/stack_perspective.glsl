// What a pixel of a perspective view sees of a stack: which scale, how far that has faded into the one before it, and the
// probes of both; where relief moves that, and how it is lit. Floating point that comes before the exact path and ends in integers (StackProbes).
// Needs stack_levels.glsl, perspective.glsl and stack_relief.glsl.

struct StackSight {
  bool hits;
  StackProbes seen;
  int light_4096;  // 4096 times the light on it
};

// How a footprint is seen that is `width` texels of the finest scale wide.
struct SeenScale {
  int scale;
  int level_256;      // log2 of the width in texels of it
  int fading_256;     // 0 ... 255
  int variation_256;  // share of its variation that is left
};

// The scale whose texels are pixels, or the next finer one. Leaves it in use, with its levels.
SeenScale stack_scale(float width) {
  SeenScale found;
  found.scale = scale_count - 1;
  found.level_256 = log2_256(width);
  found.fading_256 = 0;
  found.variation_256 = 256;
  for (int i = scale_count - 1; i >= 0; --i) {
    use_scale(i);
    if (i == 0) break;
    int ratio_256 = log2_256(float(ratio));
    if (found.level_256 < ratio_256) {
      if (found.level_256 <= 0) break;
      found.fading_256 = found.level_256 * 256 / ratio_256;
      int fade_256 = texelFetch(scale_table, ivec2(3, i), 0).w;
      found.variation_256 = 256 - fade_256 * found.fading_256 / 256;
      if (found.variation_256 < 0) found.variation_256 = 0;
      break;
    }
    found.level_256 -= ratio_256;
    found.scale = i - 1;
  }
  use_levels(found.scale);
  return found;
}

// A point of the finest scale, in a coarser one. Leaves that in use.
Position position_in_scale(Position finest, int scale) {
  Position at = finest;
  for (int i = scale_count - 1; i > scale; --i) {
    use_scale(i);
    at = coarser_position(i, at);
  }
  use_scale(scale);
  return at;
}

// Texels of the finest scale along one of `scale`.
float texels_in(int scale) {
  float size = 1.0f;
  for (int i = scale_count - 1; i > scale; --i) {
    use_scale(i);
    size = size * float(ratio);
  }
  return size;
}

// A point of `scale`: `to` texels of the finest scale from the point under the camera.
Position stack_position(Position below, vec2 to, int scale) {
  float size = texels_in(scale);
  return ground_position(position_in_scale(below, scale), vec2(to.x / size, to.y / size));
}

// The sight of a point with relief: moved along the ray and lit. `ellipse` is the pixel's, and `width` that of its probes,
// in texels of the finest scale.
StackSight with_relief(StackSight flat_sight, Position below, Ground ground, Ellipse ellipse, float width) {
  if (relief_depth == 0.0f) return flat_sight;
  StackSight sight = flat_sight;
  float size = texels_in(0);
  vec2 way = vec2(ground.to.x / view_height, ground.to.y / view_height);
  Relieved relieved = relief_at(stack_position(below, ground.to, 0), way, ellipse, size, width / size);
  float finer = size / texels_in(sight.seen.scale);
  use_scale(sight.seen.scale);
  sight.seen.row.at = moved_position(sight.seen.row.at, rounded_256(relieved.moved.x * finer), rounded_256(relieved.moved.y * finer));
  sight.light_4096 = relieved.light_4096;
  return sight;
}

// What the pixel shows: an exact product, by a multiple of 1/4096.
vec4 sight_value(StackSight sight) {
  const float per_4096 = 0.000244140625f;
  PRECISE vec4 lit = stack_probes_value(sight.seen, view_filter) * (float(sight.light_4096) * per_4096);
  return lit;
}

// `below` is the point of the finest scale under the camera; x and y as of ground_at.
StackSight stack_sight_at(Position below, float x, float y) {
  Ground ground = ground_at(x, y);
  Ellipse ellipse = ellipse_of(ground.right, ground.down);
  float width = probe_width(ellipse);
  SeenScale found = stack_scale(ground.hits ? width : 1.0f);
  // A scale that fades has no mean of its own beyond its last level.
  int last_256 = found.scale > 0 ? 256 * level_count : 256 * (level_count + 1);
  int level_256 = view_filter < 2 || found.level_256 < 0 ? 0 : found.level_256 > last_256 ? last_256 : found.level_256;

  StackSight sight;
  sight.hits = ground.hits;
  sight.seen.scale = found.scale;
  sight.seen.fading = weight_of(found.fading_256);
  sight.seen.variation = weight_of(found.variation_256);
  sight.light_4096 = 4096;
  sight.seen.coarser_halvings = 0;
  sight.seen.row.halvings = 0;
  sight.seen.row.axis_256 = ivec2(0, 0);
  sight.seen.row.level_256 = level_256;
  float size = texels_in(found.scale);
  bool reached = ground.hits && within_reach(vec2(ground.to.x / size, ground.to.y / size));
  if (!reached) sight.seen.row.level_256 = last_256;
  sight.seen.row.at = stack_position(below, reached ? ground.to : vec2(0.0f, 0.0f), found.scale);
  if (!reached) return sight;
  sight = with_relief(sight, below, ground, ellipse, width);
  float major = ellipse.major / size;
  if (view_filter < 2 || major > 65535.0f || ellipse.squared < 1e-30f) return sight;

  // Bilinear filtering is a texel wide at least, of either scale.
  float wide = width / size;
  use_scale(found.scale);
  float coarser = found.scale > 0 ? float(ratio) : 1.0f;
  sight.seen.row.halvings = halvings_of(major, wide < 1.0f ? 1.0f : wide);
  sight.seen.coarser_halvings = halvings_of(major, wide < coarser ? coarser : wide);
  sight.seen.row.axis_256 = axis_of(ellipse, size);
  return sight;
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
