// Relief of the coarsest scale in perspective: how far a pixel's ray moves what it sees, and the light there. Floating
// point, before the exact path; it ends in integers (StackSight).
// Needs relief.glsl, stack_levels.glsl, perspective.glsl and what relief_bindings.glsl binds.

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

// `at` is a point of the coarsest scale; `way` that of the ray, to the right and down, for each texel that it falls; the
// pixel is `ellipse` there, a texel being `size` of its own, and its probes `width` texels wide.
Relieved relief_at(Position at, vec2 way, Ellipse ellipse, float size, float width) {
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
  float fallen = relief_range.z - relief_height(at, slope, steps);

  Relieved relieved;
  relieved.moved = vec2(slope.x * fallen, slope.y * fallen);
  relieved.light_4096 = 4096;
  if (relief_kind == 0) return relieved;

  // The light on the mean of the normals that the pixel's probes see.
  int last_256 = 256 * (level_count + 1);
  Probes probes;
  probes.at = moved_position(at, rounded_256(relieved.moved.x), rounded_256(relieved.moved.y));
  probes.level_256 = level_256 < 0 ? 0 : level_256 > last_256 ? last_256 : level_256;
  probes.halvings = 0;
  probes.axis_256 = ivec2(0, 0);
  float major = ellipse.major / size;
  if (major < 65535.0f && ellipse.squared > 1e-30f) {
    probes.halvings = halvings_of(major, width < 1.0f ? 1.0f : width);
    probes.axis_256 = axis_of(ellipse, size);
  }
  vec4 mean = probes_value(height_plane, relief_kind, height_levels, probes);
  relieved.light_4096 = int(shade_of_normals(mean, relief_kind == 5 ? 1.0f : -1.0f, relief_light) * 4096.0f + 0.5f);
  return relieved;
}
