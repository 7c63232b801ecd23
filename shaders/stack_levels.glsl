// Levels of detail of a stack: what a scale shows over a block of its texels, with the coarser colors that the fragments
// there take.
// Based on: Lutz et al. 2019, for levels; Vanhoey et al. 2013, eq. 5, averaged over a block. Needs levels.glsl, scales.glsl
// and what stack_bindings.glsl binds, as README.md specifies under "Several scales".

// What the fragments of one entry of a block take from the coarser scale, each by its share of the block. `number` is that
// of the entry's value.
vec4 taken_by_fragments(int scale, uint number, uvec2 tile, float share, float coarser_share) {
  PRECISE vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  int i = int(number) + share_row * kListWidth;
  do {
    ivec4 fragment = texelFetch(fragment_shares, list_place(uint(i), 0), 0);
    vec4 mean = detail_mean(scale, ivec2(fragment.z & 65535, fragment.z >> 16), share);
    Texel center;
    center.tile = tile;
    center.p = ivec2((fragment.x << 16) >> 16, fragment.x >> 16);
    vec4 coarse = coarser_color(scale, center, coarser_share);
    PRECISE vec4 part = (without_w(coarse) - mean) * (coarse.w * uintBitsToFloat(uint(fragment.y)));
    sum = sum + part;
    i = fragment.w;
  } while (i > 0);
  return sum;
}

// The coarser colors over a block: the mean of the texels that lie over it, by the part of it that they cover, in 1/256.
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

// What texels of a block take that is colored as a whole, less what they replace: by the parts of coarse texels over it,
// or by what lies between four at its center. w: the share that is given.
vec4 taken_as_whole(int scale, Texel block, Grid grid, float share, float coarser_share) {
  ivec2 side = ivec2(grid.side_256.x >> 8, grid.side_256.y >> 8);
  Texel corner = block;
  corner.p = ivec2(block.p.x * side.x, block.p.y * side.y);
  Position middle;
  middle.tile = block.tile;
  middle.offset = ivec2(corner.p.x * 256 + (grid.side_256.x >> 1), corner.p.y * 256 + (grid.side_256.y >> 1));
  ivec2 around = ivec2(0, 0);
  if ((transfer_bits & kLocalMean) != 0) around = texel_source(texel_at(middle)).nearest;
  vec4 mean = detail_mean(scale, around, share);
  vec4 coarse = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  if ((transfer_bits & kTransferMode) == kTransferTexel) coarse = coarser_mean(scale, corner, side, coarser_share);
  else coarse = coarser_between(scale, middle, coarser_share);
  vec4 taken = without_w(coarse) - mean;
  taken.w = coarse.w;
  return taken;
}

// A block of `scale`, which is in use with its levels: the mean of what its texels show. A texel on a soft border is a
// block of several patches. May leave another scale in use.
vec4 scale_block(int scale, Texel block, Grid grid, float kept) {
  bool is_texel = grid.corner.x < 0;
  if (is_texel && first_level == 1) return hard_texel(scale, block, kept);
  ivec2 corner = is_texel ? ivec2(0, block_row) : grid.corner;
  uvec4 found = texelFetch(level_blocks, ivec2(corner.x + block.p.x, corner.y + block.p.y), 0);
  if (is_texel && entries_after(found) == 0u) return hard_texel(scale, block, kept);
  float share = (transfer_bits & kNoVariation) != 0 ? 0.0f : kept;
  float coarser_share = (transfer_bits & kNoCoarserVariation) != 0 ? 0.0f : 1.0f;
  bool by_fragment = scale > 0 && (transfer_bits & kTransferMode) == kTransferFragment;

  // Shares of the base, of the dominant colors, and of the coarser colors, patch by patch.
  uvec2 owned = first_owned(found);
  uint end = found.x + entries_after(found);
  PRECISE vec4 whole = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  PRECISE vec4 dominant = whole;
  PRECISE vec4 taken = whole;
  bool has_noise = noise_step != 0 && grid.noise >= 0 && share != 0.0f;
  uvec4 weights = uvec4(0u, 0u, 0u, 0u);
  for (uint entry = found.x; entry <= end; ++entry) {
    if (entry > found.x) owned = owned_by(entry);
    uint number = value_number(entry, owned, block.tile);
    if (share != 0.0f) whole = whole + texelFetch(base_levels, list_place(number, value_row), 0);
    if (share != 1.0f) dominant = dominant + texelFetch(base_levels, list_place(number, dominant_row), 0);
    if (has_noise) weights = weights + texelFetch(level_weights, list_place(number, 0), 0);
    if (by_fragment) taken = taken + taken_by_fragments(scale, number, block.tile, share, coarser_share);
  }
  if (has_noise && is_texel) whole = with_noise(whole, weights, noise_place(block));
  else if (has_noise) whole = with_noise_level(whole, weights, noise_level_place(middle_of(block, grid), grid.noise));
  vec4 own = share == 1.0f ? whole : share == 0.0f ? dominant : lerp(dominant, whole, share);
  if (scale > 0 && !by_fragment) {
    vec4 coarse = taken_as_whole(scale, block, grid, share, coarser_share);
    taken = without_w(coarse) * (own.w * coarse.w);
  }
  PRECISE vec4 arrived = without_w(own) + taken;
  return arrived;
}

// The discrete function of a scale: what its texel `at` shows. May leave another scale in use.
vec4 scale_texel(int scale, Texel at, float kept) {
  use_scale(scale);
  use_levels(scale);
  return scale_block(scale, at, grid_of(0), kept);
}
