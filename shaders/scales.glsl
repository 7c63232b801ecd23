// Several scales of one material, coarse to fine: the color of a coarse texel passes to the fine fragments inside it.
// Based on: Vanhoey et al. 2013, §6, eq. 5, Fig. 6. Needs noise.glsl, levels.glsl and what stack_bindings.glsl binds, as README.md specifies under "Several scales".
//
// One texture holds the planes of all scales, one below the other; `use_scale` says which of them the functions of
// content.glsl, sample.glsl and noise.glsl read: it sets tile_size, content_count, seed, plane_row, first_patch and
// noise_step; `use_levels` says the same to those of levels.glsl.

// What scale_table says of a scale: its four texels.
ivec4 scale_entry(int column, int scale) { return texelFetch(scale_table, ivec2(column, scale + 1), 0); }

void use_scale(int scale) {
  ivec4 plane = scale_entry(0, scale);
  ivec4 table = scale_entry(1, scale);
  tile_size = ivec2(plane.x, plane.y);
  plane_row = plane.z;
  first_patch = plane.w;
  content_count = uint(table.x);
  ratio = table.y;
  first_class = table.z;
  transfer_bits = table.w;
  first_level = (transfer_bits & kSoftBorders) != 0 ? 0 : 1;
  noise_step = scale == scale_count - 1 ? finest_noise_step : 0;
  seed = stack_seed + uint(scale_count - 1 - scale) * 2654435769u;
}

// Beside use_scale: where the levels of a scale begin.
void use_levels(int scale) {
  ivec4 lists = scale_entry(2, scale);
  ivec4 values = scale_entry(3, scale);
  level_row = lists.x;
  block_row = lists.y;
  entry_row = lists.z;
  level_count = lists.w;
  value_row = values.x;
  dominant_row = values.y;
  share_row = values.z;
}

// a / b, rounded down, for b > 0: `/` of negative integers differs between languages.
int floor_divided(int a, int b) { return a >= 0 ? a / b : -(-(a + 1) / b) - 1; }

// Where a texel lies in the next coarser scale, on one axis: its repetition there, and how far in, in texels of its
// own. `start` is the upper left corner of the repetition `reference`: of repetition start.x, start.y texels in.
ivec2 coarser_place(int x, int repetition, int side, ivec2 start, int coarse_side) {
  int distance = int(uint(start.y) + uint(repetition) * uint(side) + uint(x));
  int beyond = floor_divided(distance, coarse_side);
  return ivec2(int(uint(start.x) + uint(beyond)), int(uint(distance) - uint(beyond) * uint(coarse_side)));
}

// The place of texel `at` of `scale`, which is in use, in the scale before it: repetitions and texels of `scale`. `at.p`
// may lie outside its tile.
Position coarser_origin(int scale, Texel at) {
  uvec4 nest = nesting[scale];
  ivec2 offset = nesting_offset[scale];
  ivec4 coarse = scale_entry(0, scale - 1);
  ivec2 x = coarser_place(at.p.x, int(at.tile.x - nest.x), tile_size.x, ivec2(int(nest.z), offset.x), coarse.x * ratio);
  ivec2 y = coarser_place(at.p.y, int(at.tile.y - nest.y), tile_size.y, ivec2(int(nest.w), offset.y), coarse.y * ratio);
  Position place;
  place.tile = uvec2(uint(x.x), uint(y.x));
  place.offset = ivec2(x.y, y.y);
  return place;
}

// The texel of the scale before `scale` in which a texel of it lies.
Texel coarser_texel(int scale, Texel at) {
  Position place = coarser_origin(scale, at);
  Texel coarse;
  coarse.tile = place.tile;
  coarse.p = ivec2(place.offset.x / ratio, place.offset.y / ratio);
  return coarse;
}

// The same for a point: 1/256 texel of the coarser scale, rounded down.
Position coarser_position(int scale, Position at) {
  Position place = coarser_origin(scale, texel_at(at));
  uint x = uint(place.offset.x) * 256u + uint(at.offset.x & 255);
  uint y = uint(place.offset.y) * 256u + uint(at.offset.y & 255);
  Position coarse;
  coarse.tile = place.tile;
  coarse.offset = ivec2(int(x / uint(ratio)), int(y / uint(ratio)));
  return coarse;
}

// A point of the scale `from`, in a coarser one. Leaves that in use.
Position position_in_scale(Position point, int from, int scale) {
  Position at = point;
  for (int i = from; i > scale; --i) {
    use_scale(i);
    at = coarser_position(i, at);
  }
  use_scale(scale);
  return at;
}

// Texels of the finest scale along one of `scale`.
float texels_in(int scale) {
  float size = 1.0f;
  for (int i = scale_count - 1; i > scale; --i) {
    use_scale(i);
    size = size * float(ratio);
  }
  return size;
}

// Where the center of the fragment that shows at `at` lies in the infinite texture: a texel of the repetition at.tile,
// perhaps outside it. `labels` are those of the source; their xy lead to the center there.
// For a turned content the way from the content's center to the fragment's, the same for all of its texels, is turned
// back: by the inverse of (a, b) / 65536, which is lambda^2 (a, -b) / 65536, in 1/16384.
ivec2 fragment_center(Texel at, Decision decision, Source source, ivec4 labels) {
  if (source.matrix.x == 65536 && source.matrix.y == 0) return ivec2(at.p.x + labels.x, at.p.y + labels.y);
  ivec4 center = texelFetch(centers, ivec2(decision.patch_idx + first_patch, 0), 0);
  int patch_x = center.x + decision.owner.x * tile_size.x;
  int patch_y = center.y + decision.owner.y * tile_size.y;
  int dx = at.p.x - patch_x;
  int dy = at.p.y - patch_y;
  int from_x = ((source.matrix.x * dx - source.matrix.y * dy + 32768) >> 16) + labels.x;
  int from_y = ((source.matrix.y * dx + source.matrix.x * dy + 32768) >> 16) + labels.y;
  int square = ((source.scale >> 1) * (source.scale >> 1)) >> 15;
  int a = ((source.matrix.x >> 2) * square) >> 15;
  int b = ((source.matrix.y >> 2) * square) >> 15;
  return ivec2(patch_x + ((a * from_x + b * from_y + 8192) >> 14), patch_y + ((a * from_y - b * from_x + 8192) >> 14));
}

// A color with its variation, what it has beside the dominant color of its class, times `share` and the class's gain.
vec4 with_variation(vec4 color, int class_idx, float share) {
  vec4 entry = texelFetch(color_table, ivec2(first_class + class_idx, 0), 0);
  float kept = share * entry.w;
  if (kept == 1.0f) return color;
  return lerp(vec4(entry.x, entry.y, entry.z, 0.0f), color, kept);
}

// The mean of what with_variation gives over the tile of `scale`, or around the texel `p` of it.
vec4 detail_mean(int scale, ivec2 p, float share) {
  vec4 dominant = texelFetch(color_table, ivec2(0, scale + 2), 0);
  vec4 whole = texelFetch(color_table, ivec2(1, scale + 2), 0);
  vec4 mean = share == 1.0f ? whole : lerp(dominant, whole, share);
  if ((transfer_bits & kLocalMean) == 0) return mean;
  vec4 around = texelFetch(local_mean, ivec2(p.x, p.y + plane_row), 0);
  PRECISE vec4 moved = around + (mean - whole);
  return moved;
}

// What one scale shows at a texel, and where the next coarser one gives its color.
struct Shown {
  vec4 color;
  vec4 mean;      // of the scale's detail: what the coarser color replaces
  float giving;   // share of this color that a finer scale gets
  float taking;   // share of the coarser color that is taken
  Texel anchor;   // texel of this scale at whose place the coarser color is read; p may lie outside the tile
};

// What the patches of a texel on a soft border show there of `scale`, which is in use, whatever levels are. `alone` is what
// its own patch shows, which is all of it elsewhere. Of what a finer scale reads, which has no noise.
vec4 shared_color(int scale, Texel at, float share, vec4 alone) {
  ivec4 lists = scale_entry(2, scale);
  uvec4 block = texelFetch(level_blocks, ivec2(at.p.x, at.p.y + lists.y), 0);
  if (entries_after(block) == 0u) return alone;
  ivec4 values = scale_entry(3, scale);
  ivec2 rows = ivec2(entry_row, value_row);
  entry_row = lists.z;
  vec4 whole = alone;
  vec4 dominant = alone;
  for (int i = 0; i < 2; ++i) {
    if (share == (i == 0 ? 0.0f : 1.0f)) continue;
    value_row = i == 0 ? values.x : values.y;
    vec4 shown = shares_value(base_levels, block, at.tile);
    if (i == 0) whole = shown;
    else dominant = shown;
  }
  entry_row = rows.x;
  value_row = rows.y;
  return share == 1.0f ? whole : share == 0.0f ? dominant : lerp(dominant, whole, share);
}

// Of `scale`, which is in use. The coarser color is that of the texel's own patch.
Shown shown_texel(int scale, Texel at, float kept) {
  float share = (transfer_bits & kNoVariation) != 0 ? 0.0f : kept;
  Decision decision = decide(at);
  Source source = source_of(at, decision);
  ivec4 labels = ivec4(0, 0, 0, 0);
  if (scale > 0 || (transfer_bits & kCoarsestLabels) != 0)
    labels = texelFetch(fragment_plane, ivec2(source.nearest.x, source.nearest.y + plane_row), 0);
  Shown shown;
  shown.color = with_variation(layered_value(base, at, source), labels.w, share);
  if (first_level == 0) shown.color = shared_color(scale, at, share, shown.color);
  shown.giving = texelFetch(color_table, ivec2(first_class + labels.w, 1), 0).y;
  shown.taking = texelFetch(color_table, ivec2(first_class + labels.z, 1), 0).x;
  shown.anchor = at;
  shown.mean = shown.color;
  if (scale == 0) return shown;
  ivec2 middle = source.nearest;
  if ((transfer_bits & kTransferMode) == kTransferFragment) {
    shown.anchor.p = fragment_center(at, decision, source, labels);
    middle = ivec2(wrap_any(middle.x + labels.x, tile_size.x), wrap_any(middle.y + labels.y, tile_size.y));
  }
  shown.mean = detail_mean(scale, middle, share);
  return shown;
}

// A color in which the mean of a scale's detail gives way to the coarser color, by `weight`: eq. 5. A function of its own,
// as is the next: where `precise` has to be followed through a loop over structures, glslang takes gigabytes.
vec4 passed_color(vec4 color, vec4 coarser, vec4 mean, float weight) {
  PRECISE vec4 arrived = color + (coarser - mean) * weight;
  return arrived;
}

float product_of(float a, float b) {
  PRECISE float product = a * b;
  return product;
}

// A color with those of all coarser scales in its xyz, and in its w the share of it that a finer scale gets.
// The texel `place` of scale `finest`: eq. 5, scale by scale. `kept` is the share that is left of the finest scale's.
// Leaves another scale in use.
vec4 stacked_texel(int finest, Texel place, float kept) {
  Texel at = place;
  vec4 sum = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  vec4 mean = sum;
  float weight = 1.0f;
  float giving = 1.0f;
  float share = kept;
  for (int scale = finest; scale >= 0; --scale) {
    use_scale(scale);
    Shown shown = shown_texel(scale, at, share);
    if (scale == finest) {
      sum = shown.color;
      giving = shown.giving;
    } else {
      weight = product_of(weight, shown.giving);
      sum = passed_color(sum, shown.color, mean, weight);
    }
    if (scale == 0) break;
    weight = product_of(weight, shown.taking);
    mean = shown.mean;
    share = (transfer_bits & kNoCoarserVariation) != 0 ? 0.0f : 1.0f;
    at = coarser_texel(scale, shown.anchor);
  }
  return vec4(sum.x, sum.y, sum.z, giving);
}

vec4 without_w(vec4 color) { return vec4(color.x, color.y, color.z, 0.0f); }

// Of the four texels around a point, by the upper left one: 0 that, 1 upper right, 2 lower left, 3 lower right.
Texel surrounding_texel(Texel upper_left, int corner) {
  Texel texel = upper_left;
  if ((corner & 1) != 0) texel = right_of(texel);
  if (corner > 1) texel = below(texel);
  return texel;
}

// What stacked_texel gives of the scale before `scale`, between the four texels around a point of `scale`. Loops rather than
// calls side by side: drivers copy what a call does into every place that calls.
vec4 coarser_between(int scale, Position at, float coarser_share) {
  Position place = coarser_position(scale, at);
  use_scale(scale - 1);
  Position corner = upper_left_center(place);
  Texel start = texel_at(corner);
  vec4 left = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  vec4 upper = left;
  vec4 lower = left;
  for (int i = 0; i < 4; ++i) {
    use_scale(scale - 1);
    vec4 value = stacked_texel(scale - 1, surrounding_texel(start, i), coarser_share);
    if ((i & 1) == 0) left = value;
    else if (i == 1) upper = lerp(left, value, weight_of(corner.offset.x & 255));
    else lower = lerp(left, value, weight_of(corner.offset.x & 255));
  }
  use_scale(scale);
  return lerp(upper, lower, weight_of(corner.offset.y & 255));
}

// What a texel `at` of a scale shows that belongs to one patch. Leaves another scale in use.
vec4 hard_texel(int scale, Texel at, float kept) {
  use_scale(scale);
  if (scale == 0 || (transfer_bits & kTransferMode) != kTransferBilinear) return without_w(stacked_texel(scale, at, kept));
  Shown shown = shown_texel(scale, at, kept);
  float coarser_share = (transfer_bits & kNoCoarserVariation) != 0 ? 0.0f : 1.0f;
  Position center;
  center.tile = at.tile;
  center.offset = ivec2(at.p.x * 256 + 128, at.p.y * 256 + 128);
  vec4 coarse = coarser_between(scale, center, coarser_share);
  return passed_color(shown.color, without_w(coarse), shown.mean, product_of(shown.taking, coarse.w));
}

// What stacked_texel gives of the scale before `scale` at the texel that holds `center`. The last answer is kept: blocks
// and probes side by side mostly see one fragment. Leaves `scale` in use.
vec4 coarser_color(int scale, Texel center, float coarser_share) {
  if (kept_scale == scale && kept_tile.x == center.tile.x && kept_tile.y == center.tile.y && kept_p.x == center.p.x &&
      kept_p.y == center.p.y)
    return kept_color;
  kept_scale = scale;
  kept_tile = center.tile;
  kept_p = center.p;
  kept_color = stacked_texel(scale - 1, coarser_texel(scale, center), coarser_share);
  use_scale(scale);
  return kept_color;
}
