// Which content shows at a texel of the infinite texture, and from where in the tile it is taken: integers only.
// Based on: Vanhoey et al. 2013, §5.3; Guingo et al. 2017, §4. Needs hash.glsl and, bound as README.md says,
//   patch_plane (idx, owner), contents (t.x + 65536 t.y, 65536 lambda, a, b), centers (c.x, c.y), tile_size,
//   content_count, seed; plane_row and first_patch, where the scale in use begins in the planes and tables.

// A texel of the infinite texture: its repetition of the tile, modulo 2^32, and its place there, 0 ... size-1.
struct Texel {
  uvec2 tile;
  ivec2 p;
};

// What was decided for a texel.
struct Decision {
  int patch_idx;
  int content;   // 0 ... content_count-1
  ivec2 owner;   // -1, 0 or 1: where the center of the patch lies, in repetitions from the texel's own
};

// Where a texel of a content is taken from: a texel of the tile and, for turned or scaled contents, how far it lies
// towards the next texels to the right and below, in 1/256 texel.
struct Source {
  ivec2 nearest;   // labels and other data that must not be blended
  ivec2 texel;     // colors: the upper left of four
  ivec2 fraction;  // 0 ... 255
  ivec2 matrix;    // (a, b) of the content, 16.16
  int scale;       // lambda of the content, 16.16
};

// x in 0 ... 2n-1 to 0 ... n-1.
int wrap_once(int x, int n) { return x < n ? x : x - n; }

// x in -4n ... to 0 ... n-1. The sum is not negative, where `%` is the same in every language.
int wrap_any(int x, int n) { return int(uint(x + 4 * n) % uint(n)); }

ivec2 next_texel(ivec2 p, ivec2 size) { return ivec2(wrap_once(p.x + 1, size.x), wrap_once(p.y + 1, size.y)); }

// The content of a patch whose center lies in the repetition `tile`.
int drawn_content(int patch_idx, uvec2 tile) {
  uint drawn = content_hash(uint(patch_idx), tile, seed);
  return int(((drawn >> 16u) * content_count) >> 16u);
}

// Where the center of a patch lies: (owner.x + 1) | (owner.y + 1) << 2, in repetitions.
ivec2 owner_of(uint bits) { return ivec2(int(bits & 3u) - 1, int(bits >> 2u) - 1); }

// The repetition is taken from the patch's center, so that its halves across a border of the tile agree.
Decision decide(Texel at) {
  uvec4 owned = texelFetch(patch_plane, ivec2(at.p.x, at.p.y + plane_row), 0);
  Decision decision;
  decision.patch_idx = int(owned.x);
  decision.owner = owner_of(owned.y);
  decision.content = drawn_content(decision.patch_idx, at.tile + uvec2(decision.owner));
  return decision;
}

// A content that is only moved: one texel of the tile.
Source moved_source(ivec2 p, ivec4 content) {
  Source source;
  source.texel = ivec2(wrap_once(p.x + (content.x & 65535), tile_size.x), wrap_once(p.y + (content.x >> 16), tile_size.y));
  source.nearest = source.texel;
  source.fraction = ivec2(0, 0);
  source.matrix = ivec2(content.z, content.w);
  source.scale = content.y;
  return source;
}

// A content that is turned or scaled about the center of its patch. `offset` is in 1/65536 texel; `>>` rounds down for
// negative numbers too.
Source turned_source(ivec2 p, ivec4 content, Decision decision) {
  ivec4 center = texelFetch(centers, ivec2(decision.patch_idx + first_patch, 0), 0);
  int dx = p.x - decision.owner.x * tile_size.x - center.x;
  int dy = p.y - decision.owner.y * tile_size.y - center.y;
  int offset_x = content.z * dx - content.w * dy;
  int offset_y = content.w * dx + content.z * dy;
  int moved_x = center.x + (content.x & 65535);
  int moved_y = center.y + (content.x >> 16);

  Source source;
  source.nearest = ivec2(wrap_any(moved_x + ((offset_x + 32768) >> 16), tile_size.x),
                         wrap_any(moved_y + ((offset_y + 32768) >> 16), tile_size.y));
  int blended_x = (offset_x + 128) >> 8;
  int blended_y = (offset_y + 128) >> 8;
  source.texel = ivec2(wrap_any(moved_x + (blended_x >> 8), tile_size.x),
                       wrap_any(moved_y + (blended_y >> 8), tile_size.y));
  source.fraction = ivec2(blended_x & 255, blended_y & 255);
  source.matrix = ivec2(content.z, content.w);
  source.scale = content.y;
  return source;
}

Source source_of(Texel at, Decision decision) {
  ivec4 content = texelFetch(contents, ivec2(decision.content, decision.patch_idx + first_patch), 0);
  if (content.z == 65536 && content.w == 0) return moved_source(at.p, content);
  return turned_source(at.p, content, decision);
}
