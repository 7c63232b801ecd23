// Values of the infinite texture between its texels: fetches and lerps, in the order of README.md.
// Needs content.glsl, and PRECISE: `precise` where the language has it, else nothing.

// A point of the infinite texture: the repetition of the tile, modulo 2^32, and the place there in 1/256 texel,
// 0 ... 256 size - 1. The center of texel p is at 256 p + 128.
struct Position {
  uvec2 tile;
  ivec2 offset;
};

// The four texels around a point, and its weights towards the right and the lower ones.
struct Footprint {
  Source upper_left;
  Source upper_right;
  Source lower_left;
  Source lower_right;
  ivec2 fraction;  // 0 ... 255
};

vec4 lerp(vec4 a, vec4 b, float weight) {
  PRECISE vec4 blended = a + (b - a) * weight;
  return blended;
}

// fraction / 256, exactly.
float weight_of(int fraction) {
  const float per_256 = 0.00390625f;
  return float(fraction) * per_256;
}

vec4 bilinear(vec4 upper_left, vec4 upper_right, vec4 lower_left, vec4 lower_right, ivec2 fraction) {
  float x = weight_of(fraction.x);
  vec4 upper = lerp(upper_left, upper_right, x);
  vec4 lower = lerp(lower_left, lower_right, x);
  return lerp(upper, lower, weight_of(fraction.y));
}

// The center of pixel `pixel` of a window whose upper left corner is at `origin`, with `pixel_256` 1/256 texels to a pixel.
// 256 size < 2^23 and offset + pixel step + step / 2 < 2^32.
Position pixel_position(Position origin, uint pixel_256, uvec2 pixel) {
  uvec2 size = uvec2(uint(tile_size.x) * 256u, uint(tile_size.y) * 256u);
  uint x = uint(origin.offset.x) + pixel.x * pixel_256 + (pixel_256 >> 1u);
  uint y = uint(origin.offset.y) + pixel.y * pixel_256 + (pixel_256 >> 1u);
  Position at;
  at.tile = origin.tile + uvec2(x / size.x, y / size.y);
  at.offset = ivec2(int(x % size.x), int(y % size.y));
  return at;
}

// The texel in which a point lies.
Texel texel_at(Position at) {
  Texel texel;
  texel.tile = at.tile;
  texel.p = ivec2(at.offset.x >> 8, at.offset.y >> 8);
  return texel;
}

// The upper left of the four texels whose centers surround a point, and how far the point lies from its center.
Position upper_left_center(Position at) {
  Position moved = at;
  moved.offset = ivec2(at.offset.x - 128, at.offset.y - 128);
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

Texel right_of(Texel texel) {
  Texel right = texel;
  right.p.x = wrap_once(texel.p.x + 1, tile_size.x);
  if (right.p.x == 0) right.tile.x += 1u;
  return right;
}

Texel below(Texel texel) {
  Texel lower = texel;
  lower.p.y = wrap_once(texel.p.y + 1, tile_size.y);
  if (lower.p.y == 0) lower.tile.y += 1u;
  return lower;
}

Source texel_source(Texel at) { return source_of(at, decide(at)); }

Footprint footprint_at(Position at) {
  Position corner = upper_left_center(at);
  Texel texel = texel_at(corner);
  Texel lower = below(texel);
  Footprint footprint;
  footprint.upper_left = texel_source(texel);
  footprint.upper_right = texel_source(right_of(texel));
  footprint.lower_left = texel_source(lower);
  footprint.lower_right = texel_source(right_of(lower));
  footprint.fraction = ivec2(corner.offset.x & 255, corner.offset.y & 255);
  return footprint;
}

// What a plane of the tile shows at a texel of the infinite texture.
vec4 source_value(sampler2D plane, Source source) {
  int row = source.texel.y + plane_row;
  vec4 upper_left = texelFetch(plane, ivec2(source.texel.x, row), 0);
  if (source.fraction.x == 0 && source.fraction.y == 0) return upper_left;
  ivec2 opposite = next_texel(source.texel, tile_size);
  int lower_row = opposite.y + plane_row;
  return bilinear(upper_left, texelFetch(plane, ivec2(opposite.x, row), 0),
                  texelFetch(plane, ivec2(source.texel.x, lower_row), 0),
                  texelFetch(plane, ivec2(opposite.x, lower_row), 0), source.fraction);
}

// x, whose rounding no compiler can undo: it cannot know that lambda <= 1, so that nothing is flipped. Two products with
// a common factor, once subtracted, would else be factored where the language has no `precise`.
float rounded(float x, int scale) { return uintBitsToFloat(floatBitsToUint(x) ^ (uint(scale) >> 17u)); }

// The same for a normal map, whose vectors turn with the content: by theta alone, a multiple of pi/4. (a, b) point in
// the direction to which (1, 0) turns, x right and y up. `up` is 1 where +y of the vectors points up, else -1.
vec4 turned_normal(vec4 normal, Source source, float up) {
  ivec2 matrix = source.matrix;
  if (matrix.x > 0 && matrix.y == 0) return normal;
  float x = normal.x;
  float y = normal.y * up;
  if (matrix.x != 0 && matrix.y != 0) {
    const float cos_eighth = 0.70710678f;
    PRECISE float turned_x = (x - y) * cos_eighth;
    PRECISE float turned_y = (x + y) * cos_eighth;
    x = rounded(turned_x, source.scale);
    y = rounded(turned_y, source.scale);
  }
  // What remains: 0, 1, 2 or 3 quarters of a turn, counter-clockwise in the picture.
  vec4 turned = normal;
  if (matrix.x > 0 && matrix.y >= 0) {
    turned.x = x;
    turned.y = y * up;
  } else if (matrix.x <= 0 && matrix.y > 0) {
    turned.x = -y;
    turned.y = x * up;
  } else if (matrix.x < 0) {
    turned.x = -x;
    turned.y = -y * up;
  } else {
    turned.x = y;
    turned.y = -x * up;
  }
  return turned;
}

vec4 source_normal(sampler2D plane, Source source, float up) {
  return turned_normal(source_value(plane, source), source, up);
}

// The same for a height map, one channel: relief shrinks with the content.
vec4 scaled_height(vec4 value, Source source) {
  const float per_65536 = 0.0000152587890625f;
  PRECISE float height = value.x * (float(source.scale) * per_65536);
  return vec4(rounded(height, source.scale), 0.0f, 0.0f, 0.0f);
}

vec4 source_height(sampler2D plane, Source source) { return scaled_height(source_value(plane, source), source); }

vec4 footprint_value(sampler2D plane, Footprint footprint) {
  return bilinear(source_value(plane, footprint.upper_left), source_value(plane, footprint.upper_right),
                  source_value(plane, footprint.lower_left), source_value(plane, footprint.lower_right),
                  footprint.fraction);
}

vec4 footprint_normal(sampler2D plane, Footprint footprint, float up) {
  return bilinear(source_normal(plane, footprint.upper_left, up), source_normal(plane, footprint.upper_right, up),
                  source_normal(plane, footprint.lower_left, up), source_normal(plane, footprint.lower_right, up),
                  footprint.fraction);
}

vec4 footprint_height(sampler2D plane, Footprint footprint) {
  return bilinear(source_height(plane, footprint.upper_left), source_height(plane, footprint.upper_right),
                  source_height(plane, footprint.lower_left), source_height(plane, footprint.lower_right),
                  footprint.fraction);
}
