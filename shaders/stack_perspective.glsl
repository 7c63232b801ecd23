// What a pixel of a perspective view sees of a stack: which scale, how far that has faded into the one before it, and the
// probes of both; where relief moves that, and how it is lit. Floating point that comes before the exact path and ends in integers (StackProbes).
// Needs stack_levels.glsl, perspective.glsl and stack_relief.glsl.

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
      int fade_256 = scale_entry(3, i).w;
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

// A point of `scale`: `to` texels of the finest scale from the point under the camera.
Position stack_position(Position below, vec2 to, int scale) {
  float size = texels_in(scale);
  return ground_position(position_in_scale(below, scale_count - 1, scale), vec2(to.x / size, to.y / size));
}

// The sight of a point with relief: moved along the ray and lit. `ellipse` is the pixel's, and `width` that of its probes,
// in texels of the finest scale.
StackSight with_relief(StackSight flat_sight, Position below, Ground ground, Ellipse ellipse, float width) {
  if (relief_depth == 0.0f) return flat_sight;
  float size = texels_in(0);
  Probes pixel;
  pixel.at = stack_position(below, ground.to, 0);
  pixel.level_256 = 0;
  pixel.halvings = 0;
  pixel.axis_256 = ivec2(0, 0);
  float major = ellipse.major / size;
  float wide = width / size;
  if (major < 65535.0f && ellipse.squared > 1e-30f) {
    pixel.halvings = halvings_of(major, wide < 1.0f ? 1.0f : wide);
    pixel.axis_256 = axis_of(ellipse, size);
  }
  vec2 way = vec2(ground.to.x / view_height, ground.to.y / view_height);
  return moved_and_lit(flat_sight, relief_at(pixel, way, wide));
}

// `below` is the point of the finest scale under the camera; x and y as of ground_at.
StackSight stack_sight_at(Position below, float x, float y) {
  Ground ground = ground_at(x, y);
  Ellipse ellipse = ellipse_of(ground.right, ground.down);
  float width = probe_width(ellipse);
  SeenScale found = stack_scale(ground.hits ? width : 1.0f);
  // A scale that fades has no mean of its own beyond its last level.
  int last_256 = found.scale > 0 ? 256 * level_count : 256 * (level_count + 1);
  int level_256 = view_filter < kFilterTrilinear || found.level_256 < 0 ? 0 : found.level_256 > last_256 ? last_256 : found.level_256;

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
  if (view_filter < kFilterTrilinear || major > 65535.0f || ellipse.squared < 1e-30f) return sight;

  // Bilinear filtering is a texel wide at least, of either scale.
  float wide = width / size;
  use_scale(found.scale);
  float coarser = found.scale > 0 ? float(ratio) : 1.0f;
  sight.seen.row.halvings = halvings_of(major, wide < 1.0f ? 1.0f : wide);
  sight.seen.coarser_halvings = halvings_of(major, wide < coarser ? coarser : wide);
  sight.seen.row.axis_256 = axis_of(ellipse, size);
  return sight;
}
