// Levels of detail of a stack: what a scale shows over a block of its texels, with the coarser colours that the fragments
// there take; and what a footprint sees of the scale that shows and of the one into which it fades.
// Based on: Lutz et al. 2019, for levels; Vanhoey et al. 2013, eq. 5, averaged over a block. Needs levels.glsl, scales.glsl
// and what stack_bindings.glsl binds, as README.md specifies under "Several scales".

// Beside use_scale: where the levels of a scale begin.
void use_levels(int scale) {
  ivec4 lists = texelFetch(scale_table, ivec2(2, scale), 0);
  ivec4 values = texelFetch(scale_table, ivec2(3, scale), 0);
  level_row = lists.x;
  block_row = lists.y;
  entry_row = lists.z;
  level_count = lists.w;
  value_row = values.x;
  dominant_row = values.y;
  range_row = values.z;
}

// The mean of a scale's own colours over a block, `share` of their variation left; w: that of the share of the coarser
// colour that they take.
vec4 own_block(uvec4 block, uvec2 tile, float share) {
  vec4 whole = shares_value(base_levels, block, tile);
  if (share == 1.0f) return whole;
  int row = value_row;
  value_row = dominant_row;
  vec4 dominant = shares_value(base_levels, block, tile);
  value_row = row;
  return lerp(dominant, whole, share);
}

// What the fragments under a block take from the coarser scale, each by its share of the block.
vec4 taken_by_fragments(int scale, uvec4 block, uvec2 tile, float share, float coarser_share) {
  PRECISE vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  uint end = block.x + (block.y >> 20u);
  for (uint entry = block.x; entry <= end; ++entry) {
    uvec4 owned = texelFetch(level_entries, ivec2(int(entry & 4095u), int(entry >> 12u) + entry_row), 0);
    uint number = value_number(entry, uvec2(owned.x, owned.y), tile);
    uvec4 range = texelFetch(fragment_ranges, ivec2(int(number & 4095u), int(number >> 12u) + range_row), 0);
    for (uint i = range.x; i < range.x + range.y; ++i) {
      ivec4 fragment = texelFetch(fragment_shares, ivec2(int(i & 4095u), int(i >> 12u)), 0);
      vec4 mean = detail_mean(scale, ivec2(fragment.w & 65535, fragment.w >> 16), share);
      Texel center;
      center.tile = tile;
      center.p = ivec2(fragment.x, fragment.y);
      vec4 coarse = stacked_texel(scale - 1, coarser_texel(scale, center), coarser_share);
      use_scale(scale);
      PRECISE vec4 part = (without_w(coarse) - mean) * (coarse.w * uintBitsToFloat(uint(fragment.z)));
      sum = sum + part;
    }
  }
  return sum;
}

// The coarser colours over a block: the mean of the texels that lie over it, by the part of it that they cover, in 1/256.
// `corner` is the block's first texel, `side` its texels on each axis.
vec4 coarser_mean(int scale, Texel corner, ivec2 side, float coarser_share) {
  ivec2 start = coarser_origin(scale, corner).offset;
  int from = ratio;
  vec4 mean = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  int height = 0;
  for (int y = 0; y < side.y; y += height) {
    height = from - (start.y + y) % from;
    if (height > side.y - y) height = side.y - y;
    vec4 row = mean;
    int width = 0;
    for (int x = 0; x < side.x; x += width) {
      width = from - (start.x + x) % from;
      if (width > side.x - x) width = side.x - x;
      use_scale(scale);
      Texel texel = corner;
      texel.p = ivec2(corner.p.x + x, corner.p.y + y);
      vec4 value = stacked_texel(scale - 1, coarser_texel(scale, texel), coarser_share);
      row = lerp(row, value, weight_of(width * 256 / (x + width)));
    }
    mean = lerp(mean, row, weight_of(height * 256 / (y + height)));
  }
  use_scale(scale);
  return mean;
}

// A block of `scale`, which is in use: the mean of what its texels show. Leaves another scale in use.
vec4 scale_block(int scale, Texel block, Grid grid, float variation) {
  if (grid.corner.x < 0) return scale_texel(scale, block, variation);
  uvec4 found = texelFetch(level_blocks, ivec2(grid.corner.x + block.p.x, grid.corner.y + block.p.y), 0);
  float share = (transfer_bits & 8) != 0 ? 0.0f : variation;
  vec4 own = own_block(found, block.tile, share);
  if (scale == 0) return without_w(own);
  float coarser_share = (transfer_bits & 16) != 0 ? 0.0f : 1.0f;
  int mode = transfer_bits & 3;
  vec4 taken;
  if (mode == 0) {
    taken = taken_by_fragments(scale, found, block.tile, share, coarser_share);
  } else {
    ivec2 side = ivec2(grid.side_256.x >> 8, grid.side_256.y >> 8);
    Texel corner = block;
    corner.p = ivec2(block.p.x * side.x, block.p.y * side.y);
    Position middle;
    middle.tile = block.tile;
    middle.offset = ivec2(corner.p.x * 256 + (grid.side_256.x >> 1), corner.p.y * 256 + (grid.side_256.y >> 1));
    ivec2 around = ivec2(0, 0);
    if ((transfer_bits & 4) != 0) around = texel_source(texel_at(middle)).nearest;
    vec4 mean = detail_mean(scale, around, share);
    vec4 coarse = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    if (mode == 1) coarse = coarser_mean(scale, corner, side, coarser_share);
    else coarse = coarser_between(scale, middle, coarser_share);
    taken = (without_w(coarse) - mean) * (own.w * coarse.w);
  }
  PRECISE vec4 arrived = without_w(own) + taken;
  return arrived;
}

// A point of one scale at a level of detail: between the four blocks around it or, where `smooth_filter` is 0, the one in
// which it lies.
vec4 scale_level(int scale, Position at, int level, float variation, int smooth_filter) {
  use_scale(scale);
  use_levels(scale);
  if (level > level_count) return without_w(texelFetch(base_levels, ivec2(0, value_row), 0));
  Grid grid = grid_of(level);
  BlockCorner around = block_corner(at, grid);
  if (smooth_filter == 0) {
    ivec2 across = block_and_fraction(at.offset.x, grid.side_256.x, grid.shift.x);
    ivec2 down = block_and_fraction(at.offset.y, grid.side_256.y, grid.shift.y);
    around.first.tile = at.tile;
    around.first.p = ivec2(across.x, down.x);
  }
  int count = smooth_filter == 0 ? 1 : 4;
  vec4 left = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  vec4 upper = left;
  vec4 lower = left;
  for (int corner = 0; corner < count; ++corner) {
    use_scale(scale);
    use_levels(scale);
    vec4 value = scale_block(scale, surrounding_block(around.first, grid, corner), grid, variation);
    if ((corner & 1) == 0) left = value;
    else if (corner == 1) upper = lerp(left, value, weight_of(around.fraction.x));
    else lower = lerp(left, value, weight_of(around.fraction.x));
  }
  if (count == 1) return left;
  return lerp(upper, lower, weight_of(around.fraction.y));
}

// What a pixel sees: points in a row, all at one level of `scale`, and how far that has faded into the scale before it.
struct StackProbes {
  Probes row;             // of `scale`; level_256: 0 ... 256 (level_count + 1)
  int scale;
  int coarser_halvings;   // 2^coarser_halvings points of the scale before it, whose texels are larger
  float fading;           // 0 ... 1
  float variation;        // share of its variation that `scale` still has
};

// The mean of the probes of one scale.
vec4 scale_probes(int scale, Probes probes, float variation, int smooth_filter) {
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
      vec4 value = scale_level(scale, at, level + k, variation, smooth_filter);
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
