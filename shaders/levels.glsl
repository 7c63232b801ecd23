// Values of the infinite texture averaged over blocks of texels: levels of detail without bias, what lies between them,
// and footprints that are longer than wide.
// Based on: Lutz et al. 2019 (which patches lie under a block, and contents premultiplied by their cover of it).
// Needs noise.glsl and, bound as README.md says, level_table, level_blocks, level_entries, level_weights, level_count,
// first_level; level_row, block_row, entry_row and value_row, where the scale in use begins in them.
//
// `plane` is the base or a map, `kind` how its values change with their content (plane_kind of constants.glsl, README.md §6), `values`
// what every content of every patch shows in the blocks under it. A block of level l, about 2^l x 2^l texels, is told by
// a Texel that counts blocks: its repetition of the tile, and its place there.

// Points in a row, all at one level: what a pixel sees of a plane that it looks at slantingly.
struct Probes {
  Position at;     // the middle of the row
  ivec2 axis_256;  // from its one end to the other, in 1/256 texel, below 2^24
  int halvings;    // 2^halvings points, 0 ... 4
  int level_256;
};

// The level of a width, in floating point before the exact path: log2(x) in 1/256, 2 of them off at most; x is positive and not denormal.
int log2_256(float x) {
  uint bits = floatBitsToUint(x);
  int exponent = int(bits >> 23u) - 127;
  float t = uintBitsToFloat((bits & 8388607u) | 1065353216u) - 1.0f;  // x / 2^exponent - 1
  PRECISE float bow = (1.0f - t) * 0.3466f;
  PRECISE float fraction = t * (bow + 1.0f);
  return exponent * 256 + int(fraction * 256.0f);
}

float sum_of_squares(float a, float b) {
  PRECISE float first = a * a;
  PRECISE float second = b * b;
  PRECISE float sum = first + second;
  return sum;
}

vec4 kind_value(sampler2D plane, int kind, Source source) {
  vec4 value = source_value(plane, source);
  if (kind == kPlanePlain || kind == kPlaneStructure) return value;
  if (kind == kPlaneHeight) return scaled_height(value, source);
  if (kind == kPlaneReliefOpengl || kind == kPlaneReliefDirectx) {
    vec4 normal = turned_normal(vec4(value.y, value.z, value.w, 0.0f), source, kind == kPlaneReliefOpengl ? 1.0f : -1.0f);
    return vec4(scaled_height(value, source).x, normal.x, normal.y, normal.z);
  }
  return turned_normal(value, source, kind == kPlaneNormalOpengl ? 1.0f : -1.0f);
}

// Where a list has its element `number`, its first row being `row`.
ivec2 list_place(uint number, int row) {
  return ivec2(int(number & uint(kListWidth - 1)), int(number >> uint(kListWidthLog2)) + row);
}

// A texel of level_blocks: the first entry; its patch idx and owner, and how many entries follow. This is the patch of its
// first entry, and the number of those that follow.
uvec2 first_owned(uvec4 block) { return uvec2(block.y & 65535u, (block.y >> kBlockOwnerBit) & 15u); }
uint entries_after(uvec4 block) { return block.y >> kBlockFollowingBit; }

// The patch of an entry that is not the first of its block.
uvec2 owned_by(uint entry) {
  uvec4 owned = texelFetch(level_entries, list_place(entry, entry_row), 0);
  return uvec2(owned.x, owned.y);
}

// The number of an entry's value: of the content that its patch shows.
uint value_number(uint entry, uvec2 owned, uvec2 tile) {
  return entry * content_count + uint(drawn_content(int(owned.x), tile + uvec2(owner_of(owned.y))));
}

// What the patches under a block show there together.
struct Shares {
  vec4 value;
  uvec4 weights;  // of the noises, in 1/2048; zeros where they were not asked for
};

// The sum of all shares, in the order of the list; a share is what one patch shows there, times how much of the block it
// covers. `block` is a texel of level_blocks.
Shares shares_of(sampler2D values, uvec4 block, uvec2 tile, bool weighed) {
  PRECISE vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  uvec4 weights = uvec4(0u, 0u, 0u, 0u);
  uvec2 owned = first_owned(block);
  uint end = block.x + entries_after(block);
  for (uint entry = block.x; entry <= end; ++entry) {
    if (entry != block.x) owned = owned_by(entry);
    ivec2 place = list_place(value_number(entry, owned, tile), value_row);
    vec4 value = texelFetch(values, place, 0);
    if (entry == block.x) sum = value;
    else sum = sum + value;
    if (weighed) weights = weights + texelFetch(level_weights, place, 0);
  }
  Shares shares;
  shares.value = sum;
  shares.weights = weights;
  return shares;
}

vec4 shares_value(sampler2D values, uvec4 block, uvec2 tile) { return shares_of(values, block, tile, false).value; }

// A texel as a block, where borders are soft.
uvec4 shared_texel(Texel at) { return texelFetch(level_blocks, ivec2(at.p.x, at.p.y + block_row), 0); }

// A texel of the infinite texture. Where borders of patches are soft, those on them have shares. Noise is added last.
vec4 texel_value(sampler2D plane, int kind, sampler2D values, Texel at) {
  bool has_noise = kind == kPlaneStructure && noise_step != 0;
  bool is_shared = first_level == 0 && entries_after(shared_texel(at)) != 0u;
  if (is_shared && !has_noise) return shares_value(values, shared_texel(at), at.tile);
  Source source = source_of(at, decide(at));
  vec4 value = is_shared ? shares_value(values, shared_texel(at), at.tile) : kind_value(plane, kind, source);
  if (has_noise) return with_noise(value, source_weights(source), noise_place(at));
  return value;
}

// How a level cuts the tile into blocks.
struct Grid {
  ivec2 blocks;    // on each axis of the tile
  ivec2 corner;    // in level_blocks; texels have none: -1
  ivec2 side_256;  // of a block, in 1/256 texel
  ivec2 shift;     // side_256 = 2^shift, or 0 where it is no power of two
  int noise;       // level of the noises that has blocks as large; -1 where only their mean is left
};

Grid grid_of(int level) {
  Grid grid;
  grid.blocks = tile_size;
  grid.corner = ivec2(-1, -1);
  grid.side_256 = ivec2(256, 256);
  grid.shift = ivec2(8, 8);
  grid.noise = 0;
  if (level == 0) return grid;
  ivec4 places = texelFetch(level_table, ivec2(0, level + level_row), 0);
  ivec4 sides = texelFetch(level_table, ivec2(1, level + level_row), 0);
  grid.blocks = ivec2(places.x, places.y);
  grid.corner = ivec2(places.z, places.w + block_row);
  grid.side_256 = ivec2(sides.x, sides.y);
  grid.shift = ivec2(sides.z, sides.w);
  grid.noise = texelFetch(level_table, ivec2(2, level + level_row), 0).x;
  return grid;
}

// The texel in the middle of a block.
Texel middle_of(Texel block, Grid grid) {
  Texel texel;
  texel.tile = block.tile;
  texel.p = ivec2((block.p.x * grid.side_256.x + (grid.side_256.x >> 1)) >> 8,
                  (block.p.y * grid.side_256.y + (grid.side_256.y >> 1)) >> 8);
  return texel;
}

// Of what structure and noises show on the average, which is in the shares; what the noises have beside it is added last.
vec4 block_value(sampler2D plane, int kind, sampler2D values, Texel block, Grid grid) {
  if (grid.corner.x < 0) return texel_value(plane, kind, values, block);
  uvec4 found = texelFetch(level_blocks, ivec2(grid.corner.x + block.p.x, grid.corner.y + block.p.y), 0);
  bool has_noise = kind == kPlaneStructure && noise_step != 0 && grid.noise >= 0;
  Shares shares = shares_of(values, found, block.tile, has_noise);
  if (!has_noise) return shares.value;
  return with_noise_level(shares.value, shares.weights, noise_level_place(middle_of(block, grid), grid.noise));
}

// The block in which a place lies, and how far into it, in 1/256 of its side. `place` >= 0 is in 1/256 texel.
ivec2 block_and_fraction(int place, int side_256, int shift) {
  if (shift > 0) return ivec2(place >> shift, (place >> (shift - 8)) & 255);
  return ivec2(place / side_256, (place % side_256) * 256 / side_256);
}

// Block 0 ... 3 of the four about a point: upper left, which is `first`, upper right, lower left, lower right.
Texel surrounding_block(Texel first, Grid grid, int corner) {
  Texel block = first;
  if ((corner & 1) != 0) {
    block.p.x = wrap_once(block.p.x + 1, grid.blocks.x);
    if (block.p.x == 0) block.tile.x += 1u;
  }
  if (corner > 1) {
    block.p.y = wrap_once(block.p.y + 1, grid.blocks.y);
    if (block.p.y == 0) block.tile.y += 1u;
  }
  return block;
}

// The upper left of the four blocks whose centers surround a point, and how far the point lies from its center, in 1/256
// of its side.
struct BlockCorner {
  Texel first;
  ivec2 fraction;  // 0 ... 255
};

BlockCorner block_corner(Position at, Grid grid) {
  int x = at.offset.x - (grid.side_256.x >> 1);
  int y = at.offset.y - (grid.side_256.y >> 1);
  BlockCorner corner;
  corner.first.tile = at.tile;
  if (x < 0) {
    x += tile_size.x * 256;
    corner.first.tile.x -= 1u;
  }
  if (y < 0) {
    y += tile_size.y * 256;
    corner.first.tile.y -= 1u;
  }
  ivec2 across = block_and_fraction(x, grid.side_256.x, grid.shift.x);
  ivec2 down = block_and_fraction(y, grid.side_256.y, grid.shift.y);
  corner.first.p = ivec2(across.x, down.x);
  corner.fraction = ivec2(across.y, down.y);
  return corner;
}

// Between the four blocks whose centers surround a point. Beyond the last level: the mean of all that may be drawn.
// Loops rather than calls side by side, here and below: drivers copy what a call does into every place that calls.
vec4 level_value(sampler2D plane, int kind, sampler2D values, Position at, int level) {
  if (level > level_count) return texelFetch(values, ivec2(0, value_row), 0);
  Grid grid = grid_of(level);
  BlockCorner around = block_corner(at, grid);
  vec4 left = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  vec4 upper = left;
  vec4 lower = left;
  for (int corner = 0; corner < 4; ++corner) {
    vec4 value = block_value(plane, kind, values, surrounding_block(around.first, grid, corner), grid);
    if ((corner & 1) == 0) left = value;
    else if (corner == 1) upper = lerp(left, value, weight_of(around.fraction.x));
    else lower = lerp(left, value, weight_of(around.fraction.x));
  }
  return lerp(upper, lower, weight_of(around.fraction.y));
}

// Between the two levels next to lod_256 / 256, 0 ... level_count + 1.
vec4 trilinear_value(sampler2D plane, int kind, sampler2D values, Position at, int lod_256) {
  int level = lod_256 >> 8;
  int last = (lod_256 & 255) == 0 ? level : level + 1;
  vec4 blended = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (int i = level; i <= last; ++i) {
    vec4 value = level_value(plane, kind, values, at, i);
    if (i == level) blended = value;
    else blended = lerp(blended, value, weight_of(lod_256 & 255));
  }
  return blended;
}

// `from` and `by_256` further on one axis: repetition and place there. |by_256| < 2^30.
uvec2 moved_coordinate(uint tile, int offset, int by_256, int side) {
  uint period = uint(side) * 256u;
  uint repetitions = 1073741824u / period + 1u;  // added and taken away again, so that nothing is negative
  uint place = uint(offset + by_256) + repetitions * period;
  return uvec2(tile + place / period - repetitions, place % period);
}

Position moved_position(Position from, ivec2 by_256) {
  uvec2 x = moved_coordinate(from.tile.x, from.offset.x, by_256.x, tile_size.x);
  uvec2 y = moved_coordinate(from.tile.y, from.offset.y, by_256.y, tile_size.y);
  Position at;
  at.tile = uvec2(x.x, y.x);
  at.offset = ivec2(int(x.y), int(y.y));
  return at;
}

// The mean of the probes, evenly spaced along their axis: probe i of n at (2i + 1 - n) / 2n of it from the middle.
vec4 probes_value(sampler2D plane, int kind, sampler2D values, Probes probes) {
  int count = 1 << probes.halvings;
  PRECISE vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (int i = 0; i < count; ++i) {
    int place = 2 * i + 1 - count;
    ivec2 by_256 = ivec2((probes.axis_256.x * place) >> (probes.halvings + 1),
                         (probes.axis_256.y * place) >> (probes.halvings + 1));
    sum = sum + trilinear_value(plane, kind, values, moved_position(probes.at, by_256), probes.level_256);
  }
  float share = uintBitsToFloat(uint(127 - probes.halvings) << 23u);  // 1 / count, exactly
  PRECISE vec4 mean = sum * share;
  return mean;
}
