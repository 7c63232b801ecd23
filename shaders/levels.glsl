// Values of the infinite texture averaged over blocks of texels: levels of detail without bias, what lies between them,
// and footprints that are longer than wide.
// Based on: Lutz et al. 2019 (which patches lie under a block, and contents premultiplied by their cover of it).
// Needs noise.glsl and, bound as README.md says, level_blocks, level_entries, level_count, first_level.
//
// `plane` is the base or a map, `kind` how its values change with their content (plane_kind in reference.frag, README.md §6), `values`
// what every content of every patch shows in the blocks under it. A block of level l, 2^l x 2^l texels, is told by a
// Texel that counts blocks: its repetition of the tile, and its place there, 0 ... (size >> l) - 1.

// Points in a row, all at one level: what a pixel sees of a plane that it looks at slantingly.
struct Probes {
  Position at;     // the middle of the row
  ivec2 axis_256;  // from its one end to the other, in 1/256 texel, below 2^24
  int halvings;    // 2^halvings points, 0 ... 4
  int level_256;
};

vec4 kind_value(sampler2D plane, int kind, Source source) {
  vec4 value = source_value(plane, source);
  if (kind == 0 || kind == 4) return value;
  if (kind == 3) return scaled_height(value, source);
  return turned_normal(value, source, kind == 1 ? 1.0f : -1.0f);
}

// One share of a block: what one patch shows there, times how much of the block it covers.
vec4 entry_value(sampler2D values, uint entry, uvec2 owned, uvec2 tile) {
  uvec2 owner = uvec2(ivec2(int(owned.y & 3u) - 1, int(owned.y >> 2u) - 1));
  uint place = entry * content_count + uint(drawn_content(int(owned.x), tile + owner));
  return texelFetch(values, ivec2(int(place & 4095u), int(place >> 12u)), 0);
}

// The sum of all shares, in the order of the list. `block` is a texel of level_blocks: the first entry; its patch idx,
// owner << 16 and, << 20, how many entries follow.
vec4 shares_value(sampler2D values, uvec4 block, uvec2 tile) {
  PRECISE vec4 sum = entry_value(values, block.x, uvec2(block.y & 65535u, (block.y >> 16u) & 15u), tile);
  uint end = block.x + (block.y >> 20u);
  for (uint entry = block.x + 1u; entry <= end; ++entry) {
    uvec4 owned = texelFetch(level_entries, ivec2(int(entry & 4095u), int(entry >> 12u)), 0);
    sum = sum + entry_value(values, entry, uvec2(owned.x, owned.y), tile);
  }
  return sum;
}

// A texel of the infinite texture. Where borders of patches are soft, those on them have shares; grain is weighed there
// by the masks of the texel's own patch.
vec4 texel_value(sampler2D plane, int kind, sampler2D values, Texel at) {
  Source source = source_of(at, decide(at));
  if (first_level == 0) {
    uvec4 block = texelFetch(level_blocks, ivec2(at.p.x, at.p.y + (tile_size.y >> 1)), 0);
    if ((block.y >> 20u) != 0u) {
      vec4 value = shares_value(values, block, at.tile);
      if (kind == 4) return with_noise(value, source_weights(source), noise_place(at));
      return value;
    }
  }
  if (kind == 4) return layered_value(plane, at, source);
  return kind_value(plane, kind, source);
}

// Where a level lies in level_blocks: level 1 on the left, the others below each other beside it.
ivec2 level_corner(int level) {
  if (level == 1) return ivec2(0, 0);
  return ivec2(tile_size.x >> 1, (tile_size.y >> 1) - (tile_size.y >> (level - 1)));
}

vec4 block_value(sampler2D plane, int kind, sampler2D values, Texel block, int level) {
  if (level == 0) return texel_value(plane, kind, values, block);
  ivec2 corner = level_corner(level);
  uvec4 found = texelFetch(level_blocks, ivec2(corner.x + block.p.x, corner.y + block.p.y), 0);
  return shares_value(values, found, block.tile);
}

// A point, half a block up and left of `at`: it lies in the first of the four blocks whose centres surround `at`.
Position first_center(Position at, int level) {
  Position moved = at;
  moved.offset = ivec2(at.offset.x - (128 << level), at.offset.y - (128 << level));
  if (moved.offset.x < 0) {
    moved.offset.x += tile_size.x * 256;
    moved.tile.x -= 1u;
  }
  if (moved.offset.y < 0) {
    moved.offset.y += tile_size.y * 256;
    moved.tile.y -= 1u;
  }
  return moved;
}

// Block 0 ... 3 of the four: upper left, upper right, lower left, lower right.
Texel surrounding_block(Position first, int level, int corner) {
  Texel block;
  block.tile = first.tile;
  block.p = ivec2(first.offset.x >> (level + 8), first.offset.y >> (level + 8));
  if ((corner & 1) != 0) {
    block.p.x = wrap_once(block.p.x + 1, tile_size.x >> level);
    if (block.p.x == 0) block.tile.x += 1u;
  }
  if (corner > 1) {
    block.p.y = wrap_once(block.p.y + 1, tile_size.y >> level);
    if (block.p.y == 0) block.tile.y += 1u;
  }
  return block;
}

// Between the four blocks whose centres surround a point. Beyond the last level: the mean of all that may be drawn.
// Loops rather than calls side by side, here and below: drivers copy what a call does into every place that calls.
vec4 level_value(sampler2D plane, int kind, sampler2D values, Position at, int level) {
  if (level > level_count) return texelFetch(values, ivec2(0, 0), 0);
  Position first = first_center(at, level);
  float across = weight_of((first.offset.x >> level) & 255);
  vec4 left = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  vec4 upper = left;
  vec4 lower = left;
  for (int corner = 0; corner < 4; ++corner) {
    vec4 value = block_value(plane, kind, values, surrounding_block(first, level, corner), level);
    if ((corner & 1) == 0) left = value;
    else if (corner == 1) upper = lerp(left, value, across);
    else lower = lerp(left, value, across);
  }
  return lerp(upper, lower, weight_of((first.offset.y >> level) & 255));
}

// Between the two levels next to level_256 / 256, 0 ... level_count + 1.
vec4 trilinear_value(sampler2D plane, int kind, sampler2D values, Position at, int level_256) {
  int level = level_256 >> 8;
  int last = (level_256 & 255) == 0 ? level : level + 1;
  vec4 blended = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  for (int i = level; i <= last; ++i) {
    vec4 value = level_value(plane, kind, values, at, i);
    if (i == level) blended = value;
    else blended = lerp(blended, value, weight_of(level_256 & 255));
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
