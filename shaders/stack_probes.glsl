// What a pixel shows of a stack: the mean of its probes, between the four blocks around each, between levels of detail, and
// between the scale that shows and the one into which it fades. Needs stack_levels.glsl and stack_relief.glsl.

// A point of one scale at a level of detail: between the four blocks around it or, where `smooth_filter` is kFilterNearest, the one in
// which it lies.
vec4 scale_level(int scale, Position at, int level, float kept, int smooth_filter) {
  use_scale(scale);
  use_levels(scale);
  if (level > level_count) return without_w(texelFetch(base_levels, ivec2(0, value_row), 0));
  Grid grid = grid_of(level);
  BlockCorner around = block_corner(at, grid);
  if (smooth_filter == kFilterNearest) {
    ivec2 across = block_and_fraction(at.offset.x, grid.side_256.x, grid.shift.x);
    ivec2 down = block_and_fraction(at.offset.y, grid.side_256.y, grid.shift.y);
    around.first.tile = at.tile;
    around.first.p = ivec2(across.x, down.x);
  }
  int count = smooth_filter == kFilterNearest ? 1 : 4;
  vec4 left = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  vec4 upper = left;
  vec4 lower = left;
  for (int corner = 0; corner < count; ++corner) {
    use_scale(scale);
    vec4 value = scale_block(scale, surrounding_block(around.first, grid, corner), grid, kept);
    if ((corner & 1) == 0) left = value;
    else if (corner == 1) upper = lerp(left, value, weight_of(around.fraction.x));
    else lower = lerp(left, value, weight_of(around.fraction.x));
  }
  if (count == 1) return left;
  return lerp(upper, lower, weight_of(around.fraction.y));
}

// The mean of the probes of one scale.
vec4 scale_probes(int scale, Probes probes, float kept, int smooth_filter) {
  int count = 1 << probes.halvings;
  int level = probes.level_256 >> 8;
  int levels = (probes.level_256 & 255) == 0 ? 1 : 2;
  PRECISE vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (int i = 0; i < count; ++i) {
    int place = 2 * i + 1 - count;
    ivec2 by_256 = ivec2((probes.axis_256.x * place) >> (probes.halvings + 1),
                         (probes.axis_256.y * place) >> (probes.halvings + 1));
    use_scale(scale);
    Position at = moved_position(probes.at, by_256);
    vec4 blended = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    for (int k = 0; k < levels; ++k) {
      vec4 value = scale_level(scale, at, level + k, kept, smooth_filter);
      if (k == 0) blended = value;
      else blended = lerp(blended, value, weight_of(probes.level_256 & 255));
    }
    sum = sum + blended;
  }
  float share = uintBitsToFloat(uint(127 - probes.halvings) << 23u);  // 1 / count, exactly
  PRECISE vec4 mean = sum * share;
  return mean;
}

// A point, or a row of them, between two scales.
vec4 stack_probes_value(StackProbes seen, int smooth_filter) {
  vec4 blended = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (int i = 0; i < 2; ++i) {
    if (i == 0 && seen.fading == 1.0f) continue;
    if (i == 1 && seen.fading == 0.0f) break;
    Probes probes = seen.row;
    if (i == 1) {
      use_scale(seen.scale);
      probes.at = coarser_position(seen.scale, probes.at);
      probes.axis_256 = ivec2(floor_divided(probes.axis_256.x, ratio), floor_divided(probes.axis_256.y, ratio));
      probes.halvings = seen.coarser_halvings;
      probes.level_256 = 0;
    }
    vec4 value = scale_probes(seen.scale - i, probes, i == 0 ? seen.variation : 1.0f, smooth_filter);
    if (i == 0 || seen.fading == 1.0f) blended = value;
    else blended = lerp(blended, value, seen.fading);
  }
  return blended;
}

// What the pixel shows: an exact product, by a multiple of 1/4096.
vec4 sight_value(StackSight sight, int smooth_filter) {
  const float per_4096 = 0.000244140625f;
  PRECISE vec4 lit = stack_probes_value(sight.seen, smooth_filter) * (float(sight.light_4096) * per_4096);
  return lit;
}
