// Deformation by the artist: what the structure and its masks show is stretched, turned and stirred; the grain is not.
// Based on: Guingo et al. 2017, §4, Fig. 3 and 10. Integers up to the position in the structure. Needs levels.glsl and,
// bound as README.md says,
//   deformed (0: nothing is), deform_matrix (structure from picture, in 1/65536), deform_from_tile and deform_from (a
//   texel of the picture near those drawn), deform_to_tile and deform_to (where its center is taken from: texel, and
//   1/65536 texel), deform_axis_256 and deform_probes (what a pixel sees of the structure: the longer axis from its one
//   end to the other in 1/256 texel; level of detail in 1/256, and log2 of the number of points), turbulence (amplitude
//   in 1/256 texel, log2 of the side of its cells in texels, 4 ... 10).

// a i / 65536 as whole texels and the rest in 1/65536, 0 ... 65535: exact for |a| <= 2^17, |i| < 2^24.
ivec2 scaled(int a, int i) {
  int high = a * (i >> 12);
  int low = a * (i & 4095);
  int rest = (high & 15) * 4096 + (low & 65535);
  return ivec2((high >> 4) + (low >> 16) + (rest >> 16), rest & 65535);
}

// Smooth between 0 and 32768 while t goes from 0 to 1024: t^2 (3 - 2 t).
int smooth_weight(int t) { return int((uint(t) * uint(t) * uint(3072 - 2 * t)) >> 15u); }

int blended_lattice(int a, int b, int weight) { return a + (((b - a) * weight) >> 15); }

// A vector of the lattice, -amplitude ... amplitude.
ivec2 lattice_vector(uint x, uint y, int octave, int amplitude) {
  uint drawn = content_hash(4294901760u + uint(octave), uvec2(x, y), seed);
  return ivec2(((int(drawn & 65535u) - 32768) * amplitude) >> 15, ((int(drawn >> 16u) - 32768) * amplitude) >> 15);
}

// Smooth noise at a texel of the picture, in 1/256 texel: one octave on cells of 2^cell_log2 texels.
ivec2 lattice_noise(uint x, uint y, int octave, int amplitude, int cell_log2) {
  uint cell_x = x >> uint(cell_log2);
  uint cell_y = y >> uint(cell_log2);
  uint last = (1u << uint(cell_log2)) - 1u;
  int weight_x = smooth_weight(int((x & last) << uint(10 - cell_log2)));
  int weight_y = smooth_weight(int((y & last) << uint(10 - cell_log2)));
  uint last_cell = 4294967295u >> uint(cell_log2);
  uint next_x = (cell_x + 1u) & last_cell;
  uint next_y = (cell_y + 1u) & last_cell;
  ivec2 upper_left = lattice_vector(cell_x, cell_y, octave, amplitude);
  ivec2 upper_right = lattice_vector(next_x, cell_y, octave, amplitude);
  ivec2 lower_left = lattice_vector(cell_x, next_y, octave, amplitude);
  ivec2 lower_right = lattice_vector(next_x, next_y, octave, amplitude);
  return ivec2(blended_lattice(blended_lattice(upper_left.x, upper_right.x, weight_x),
                               blended_lattice(lower_left.x, lower_right.x, weight_x), weight_y),
               blended_lattice(blended_lattice(upper_left.y, upper_right.y, weight_x),
                               blended_lattice(lower_left.y, lower_right.y, weight_x), weight_y));
}

// How far turbulence moves a texel of the picture: three octaves, each of half the amplitude on half the cells. The
// coordinates wrap at 2^32, and so do the lattices.
ivec2 texel_turbulence(Texel at) {
  uint x = at.tile.x * uint(tile_size.x) + uint(at.p.x);
  uint y = at.tile.y * uint(tile_size.y) + uint(at.p.y);
  ivec2 coarse = lattice_noise(x, y, 0, turbulence.x, turbulence.y);
  ivec2 middle = lattice_noise(x, y, 1, turbulence.x >> 1, turbulence.y - 1);
  ivec2 fine = lattice_noise(x, y, 2, turbulence.x >> 2, turbulence.y - 2);
  return ivec2(coarse.x + middle.x + fine.x, coarse.y + middle.y + fine.y);
}

// The same of a point: between the four texels around it.
ivec2 turbulence_at(Position at) {
  if (turbulence.x == 0) return ivec2(0, 0);
  Position corner = upper_left_center(at);
  Texel texel = texel_at(corner);
  int x = (corner.offset.x & 255) << 7;
  int y = (corner.offset.y & 255) << 7;
  ivec2 upper_left = texel_turbulence(texel);
  if (x == 0 && y == 0) return upper_left;
  Texel lower = below(texel);
  ivec2 upper_right = texel_turbulence(right_of(texel));
  ivec2 lower_left = texel_turbulence(lower);
  ivec2 lower_right = texel_turbulence(right_of(lower));
  return ivec2(blended_lattice(blended_lattice(upper_left.x, upper_right.x, x),
                               blended_lattice(lower_left.x, lower_right.x, x), y),
               blended_lattice(blended_lattice(upper_left.y, upper_right.y, x),
                               blended_lattice(lower_left.y, lower_right.y, x), y));
}

// Along one axis: `whole` texels, |whole| < 2^26, and `part` 1/256 texel from the start of repetition `tile` to a
// repetition and an offset in 1/256 texel.
uvec2 wrapped_axis(uint tile, int whole, int part, int side) {
  uint n = uint(side);
  uint repetitions = 67108864u / n + 1u;
  uint moved = uint(whole + (part >> 8)) + repetitions * n;
  return uvec2(tile + moved / n - repetitions, (moved % n) * 256u + uint(part & 255));
}

// Where the structure of a point of the picture is taken from.
Position deformed_position(Position at) {
  int i = int((at.tile.x - deform_from_tile.x) * uint(tile_size.x) + uint(at.offset.x >> 8) - uint(deform_from.x));
  int j = int((at.tile.y - deform_from_tile.y) * uint(tile_size.y) + uint(at.offset.y >> 8) - uint(deform_from.y));
  int part_i = (at.offset.x & 255) - 128;  // from the texel's center, 1/256 texel
  int part_j = (at.offset.y & 255) - 128;
  ivec2 x_i = scaled(deform_matrix.x, i);
  ivec2 x_j = scaled(deform_matrix.y, j);
  ivec2 y_i = scaled(deform_matrix.z, i);
  ivec2 y_j = scaled(deform_matrix.w, j);
  int rest_x = deform_to.z + x_i.y + x_j.y + ((deform_matrix.x * part_i + deform_matrix.y * part_j) >> 8);
  int rest_y = deform_to.w + y_i.y + y_j.y + ((deform_matrix.z * part_i + deform_matrix.w * part_j) >> 8);
  ivec2 stirred = turbulence_at(at);
  uvec2 x = wrapped_axis(deform_to_tile.x, deform_to.x + x_i.x + x_j.x, (rest_x >> 8) + stirred.x, tile_size.x);
  uvec2 y = wrapped_axis(deform_to_tile.y, deform_to.y + y_i.x + y_j.x, (rest_y >> 8) + stirred.y, tile_size.y);
  Position position;
  position.tile = uvec2(x.x, y.x);
  position.offset = ivec2(int(x.y), int(y.y));
  return position;
}

// The structure of a texel and its weights of the noises; so, below, of blocks, between them, between levels of detail, and
// of rows of points. Loops once more, not calls side by side.
Shares texel_shares(sampler2D plane, int kind, sampler2D values, Texel at) {
  bool is_shared = first_level == 0 && entries_after(shared_texel(at)) != 0u;
  Source source = source_of(at, decide(at));
  Shares shares;
  shares.value = is_shared ? shares_value(values, shared_texel(at), at.tile) : kind_value(plane, kind, source);
  shares.weights = noise_step == 0 ? uvec4(2048u, 0u, 0u, 0u) : source_weights(source);
  return shares;
}

Shares block_shares(sampler2D plane, int kind, sampler2D values, Texel block, Grid grid) {
  if (grid.corner.x < 0) return texel_shares(plane, kind, values, block);
  uvec4 found = texelFetch(level_blocks, ivec2(grid.corner.x + block.p.x, grid.corner.y + block.p.y), 0);
  return shares_of(values, found, block.tile, noise_step != 0);
}

Shares level_shares(sampler2D plane, int kind, sampler2D values, Position at, int level) {
  Shares whole;
  whole.value = texelFetch(values, ivec2(0, value_row), 0);
  whole.weights = noise_step == 0 ? uvec4(2048u, 0u, 0u, 0u) : texelFetch(level_weights, ivec2(0, value_row), 0);
  if (level > level_count) return whole;
  Grid grid = grid_of(level);
  BlockCorner around = block_corner(at, grid);
  vec4 left = whole.value;
  vec4 upper = left;
  vec4 lower = left;
  uvec4 weights[4];
  for (int corner = 0; corner < 4; ++corner) {
    Shares shares = block_shares(plane, kind, values, surrounding_block(around.first, grid, corner), grid);
    weights[corner] = shares.weights;
    if ((corner & 1) == 0) left = shares.value;
    else if (corner == 1) upper = lerp(left, shares.value, weight_of(around.fraction.x));
    else lower = lerp(left, shares.value, weight_of(around.fraction.x));
  }
  whole.value = lerp(upper, lower, weight_of(around.fraction.y));
  whole.weights = blended_weights(weights[0], weights[1], weights[2], weights[3], around.fraction);
  return whole;
}

Shares probes_shares(sampler2D plane, int kind, sampler2D values, Probes probes) {
  int count = 1 << probes.halvings;
  int level = probes.level_256 >> 8;
  int part = probes.level_256 & 255;
  PRECISE vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  uvec4 weights = uvec4(0u, 0u, 0u, 0u);
  for (int i = 0; i < count; ++i) {
    int place = 2 * i + 1 - count;
    ivec2 by_256 = ivec2((probes.axis_256.x * place) >> (probes.halvings + 1),
                         (probes.axis_256.y * place) >> (probes.halvings + 1));
    Position at = moved_position(probes.at, by_256);
    vec4 blended = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    for (int k = 0; k < (part == 0 ? 1 : 2); ++k) {
      Shares shares = level_shares(plane, kind, values, at, level + k);
      if (k == 0) blended = shares.value;
      else blended = lerp(blended, shares.value, weight_of(part));
      weights = weights + shares.weights * uint(k == 0 ? 256 - part : part);
    }
    sum = sum + blended;
  }
  float share = uintBitsToFloat(uint(127 - probes.halvings) << 23u);  // 1 / count, exactly
  PRECISE vec4 mean = sum * share;
  Shares shares;
  shares.value = mean;
  shares.weights = weights >> uint(8 + probes.halvings);
  shares.weights.x = 2048u - shares.weights.y - shares.weights.z - shares.weights.w;
  return shares;
}

// Along one axis, from `x` texels and `part` 1/256 texel: the last block of 2^level texels whose center is not beyond that,
// and how far it lies from the center, in 1/256 of the block's side.
uvec2 block_before(uint x, int part, int level) {
  int moved = level == 0 ? part - 128 : part;
  uint whole = x - (level > 0 ? 1u << uint(level - 1) : moved < 0 ? 1u : 0u);
  uint rest = ((whole & ((1u << uint(level)) - 1u)) << 8u) | uint(moved & 255);
  return uvec2(whole >> uint(level), rest >> uint(level));
}

// Structure and the noises around a point of the picture, between their blocks of 2^level x 2^level texels; beyond the
// noises' last level they are as on it.
vec4 with_noise_around(Shares shares, Position at, int level) {
  int used = level > noise_log2.y ? noise_log2.y : level;
  uvec2 x = block_before(at.tile.x * uint(tile_size.x) + uint(at.offset.x >> 8), at.offset.x & 255, used);
  uvec2 y = block_before(at.tile.y * uint(tile_size.y) + uint(at.offset.y >> 8), at.offset.y & 255, used);
  vec4 left = shares.value;
  vec4 upper = left;
  vec4 lower = left;
  for (int corner = 0; corner < 4; ++corner) {
    ivec2 place = noise_place_of(x.x + uint(corner & 1), y.x + uint(corner >> 1), used);
    vec4 value = used == 0 ? with_noise(shares.value, shares.weights, place)
                           : with_noise_level(shares.value, shares.weights, place);
    if ((corner & 1) == 0) left = value;
    else if (corner == 1) upper = lerp(left, value, weight_of(int(x.y)));
    else lower = lerp(left, value, weight_of(int(x.y)));
  }
  return lerp(upper, lower, weight_of(int(y.y)));
}

// What a point of the picture shows: the structure over its footprint, and the noises at the point, at `picture_level_256`.
vec4 deformed_value(sampler2D plane, int kind, sampler2D values, Position at, int smooth_filter, int picture_level_256) {
  Texel texel = texel_at(at);
  Probes probes;
  probes.at = at;
  if (smooth_filter == kFilterNearest) probes.at.offset = ivec2(texel.p.x * 256 + 128, texel.p.y * 256 + 128);
  probes.at = deformed_position(probes.at);
  probes.axis_256 = deform_axis_256;
  probes.halvings = deform_probes.y;
  probes.level_256 = deform_probes.x;
  Shares shares = probes_shares(plane, kind, values, probes);
  if (noise_step == 0) return shares.value;
  if (smooth_filter == kFilterNearest) return with_noise(shares.value, shares.weights, noise_place(texel));
  int level = picture_level_256 >> 8;
  vec4 value = with_noise_around(shares, at, level);
  if ((picture_level_256 & 255) == 0) return value;
  return lerp(value, with_noise_around(shares, at, level + 1), weight_of(picture_level_256 & 255));
}
