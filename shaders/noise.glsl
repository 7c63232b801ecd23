// The noise layer: grain that belongs to the place where it is seen, weighed by masks that belong to what is seen.
// Based on: Guingo et al. 2017, eq. 2 and 6. Needs sample.glsl and, bound as README.md says,
//   masks (weights of up to four noises in 1/2048), noise_tiles (the noises, one below the other, the levels of detail
//   of each to its right), noise_log2 (log2 of the values of a noise in a row of noise_tiles, and of its rows), noise_step
//   (odd; 0 without noise), noise_root (1 where noise is added to the square root of light, 0 where to light).

// Where noise_tiles has what a noise shows at the block (x, y) of 2^level x 2^level texels. Its values follow one another
// along a row of blocks, in the next row noise_step further, and after the last comes the first: neighbors are
// neighbors everywhere, and nothing repeats along the axes or with tiles. Levels 1 ... stand on one another right of the
// noise: half as many values, then half of those, and so on.
ivec2 noise_place_of(uint x, uint y, int level) {
  uint n = x + uint(noise_step) * y;
  int columns = 1 << noise_log2.x;
  int rows = 1 << noise_log2.y;
  ivec2 corner = level == 0 ? ivec2(0, 0) : ivec2(columns, rows - (rows >> (level - 1)));
  return ivec2(corner.x + int(n & uint(columns - 1)),
               corner.y + int((n >> uint(noise_log2.x)) & uint((rows >> level) - 1)));
}

// The same of the block in which a texel of the infinite texture lies, whose coordinates wrap at 2^32.
ivec2 noise_level_place(Texel at, int level) {
  return noise_place_of((at.tile.x * uint(tile_size.x) + uint(at.p.x)) >> uint(level),
                        (at.tile.y * uint(tile_size.y) + uint(at.p.y)) >> uint(level), level);
}

ivec2 noise_place(Texel at) { return noise_level_place(at, 0); }

// Weights between those of four texels, in 1/2048 rounded down; the first noise takes what that leaves over, so that
// the sum stays 2048. Integers: 2048 * 65536 < 2^32.
uvec4 blended_weights(uvec4 upper_left, uvec4 upper_right, uvec4 lower_left, uvec4 lower_right, ivec2 fraction) {
  uint x = uint(fraction.x);
  uint y = uint(fraction.y);
  uvec4 upper = upper_left * (256u - x) + upper_right * x;
  uvec4 lower = lower_left * (256u - x) + lower_right * x;
  uvec4 blended = (upper * (256u - y) + lower * y) >> 16u;
  blended.x = 2048u - blended.y - blended.z - blended.w;
  return blended;
}

// The weights that the tile shows at a texel of the infinite texture.
uvec4 source_weights(Source source) {
  uvec4 upper_left = texelFetch(masks, source.texel, 0);
  if (source.fraction.x == 0 && source.fraction.y == 0) return upper_left;
  ivec2 opposite = next_texel(source.texel, tile_size);
  return blended_weights(upper_left, texelFetch(masks, ivec2(opposite.x, source.texel.y), 0),
                         texelFetch(masks, ivec2(source.texel.x, opposite.y), 0), texelFetch(masks, opposite, 0),
                         source.fraction);
}

vec4 noise_value(int k, ivec2 place) {
  return texelFetch(noise_tiles, ivec2(place.x, place.y + (k << noise_log2.y)), 0);
}

// The noises at a place, weighed. A weight has at most 13 significant bits, a noise, being a half float, 11: their product
// is exact, so that neither a fused multiply-add nor another order of factors changes a bit. Noises of weight 0 are not
// fetched.
vec4 weighed_noise(uvec4 weights, ivec2 place) {
  const float per_2048 = 0.00048828125f;
  PRECISE vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  if (weights.x != 0u) sum = sum + noise_value(0, place) * (float(weights.x) * per_2048);
  if (weights.y != 0u) sum = sum + noise_value(1, place) * (float(weights.y) * per_2048);
  if (weights.z != 0u) sum = sum + noise_value(2, place) * (float(weights.z) * per_2048);
  if (weights.w != 0u) sum = sum + noise_value(3, place) * (float(weights.w) * per_2048);
  return sum;
}

// 2 sqrt(x), 0 where x < 0, within 5e-6 of itself: two steps of Newton's method from a guess by the exponent's half, in
// additions and products alone, which are exact on every machine.
float twice_root(float x) {
  if (x <= 0.0f) return 0.0f;
  PRECISE float half_x = 0.5f * x;
  PRECISE float y = uintBitsToFloat(1597463007u - (floatBitsToUint(x) >> 1u));  // 1 / sqrt(x) within 4 %
  for (int step = 0; step < 2; ++step) {
    PRECISE float bend = half_x * y;
    PRECISE float excess = bend * y;
    PRECISE float factor = 1.5f - excess;
    y = y * factor;
  }
  PRECISE float root = x * y;
  return root + root;
}

vec4 twice_roots(vec4 light) { return vec4(twice_root(light.x), twice_root(light.y), twice_root(light.z), 0.0f); }

// Structure and noise at one texel: their sum or, in the square root, (sqrt(structure) + noise)^2.
vec4 with_noise(vec4 structure, uvec4 weights, ivec2 place) {
  vec4 noise = weighed_noise(weights, place);
  PRECISE vec4 change = noise;
  if (noise_root != 0) change = noise * (twice_roots(structure) + noise);
  PRECISE vec4 sum = structure + change;
  return sum;
}

// The same over a block. `mean` is what it shows on the average over all places; what the noises have there beside their
// means is at `place`, and what their squares have is as far to the right as a noise is wide.
vec4 with_noise_level(vec4 mean, uvec4 weights, ivec2 place) {
  PRECISE vec4 change = weighed_noise(weights, place);
  if (noise_root != 0) {
    change = change * twice_roots(mean);
    change = change + weighed_noise(weights, ivec2(place.x + (1 << noise_log2.x), place.y));
  }
  PRECISE vec4 sum = mean + change;
  return sum;
}

// Structure and noise at a texel of the infinite texture whose source is known.
vec4 layered_value(sampler2D plane, Texel at, Source source) {
  vec4 structure = source_value(plane, source);
  if (noise_step == 0) return structure;
  return with_noise(structure, source_weights(source), noise_place(at));
}

// The same between the four texels around a point: the sums of both layers are blended.
vec4 footprint_layers(sampler2D plane, Footprint footprint, Position at) {
  Texel texel = texel_at(upper_left_center(at));
  Texel lower = below(texel);
  return bilinear(layered_value(plane, texel, footprint.upper_left),
                  layered_value(plane, right_of(texel), footprint.upper_right),
                  layered_value(plane, lower, footprint.lower_left),
                  layered_value(plane, right_of(lower), footprint.lower_right), footprint.fraction);
}
