// Deformation by the artist: what the structure and its masks show is stretched, turned and stirred; the grain is not.
// Based on: Guingo et al. 2017, §4, Fig. 3 and 10. Integers up to the position in the structure. Needs noise.glsl and,
// bound as README.md says,
//   deformed (0: nothing is), deform_matrix (structure from picture, in 1/65536), deform_from_tile and deform_from (a
//   texel of the picture near those drawn), deform_to_tile and deform_to (where its center is taken from: texel, and
//   1/65536 texel), turbulence (amplitude in 1/256 texel, log2 of the side of its cells in texels, 4 ... 10).

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
ivec2 turbulence_at(Texel at) {
  if (turbulence.x == 0) return ivec2(0, 0);
  uint x = at.tile.x * uint(tile_size.x) + uint(at.p.x);
  uint y = at.tile.y * uint(tile_size.y) + uint(at.p.y);
  ivec2 coarse = lattice_noise(x, y, 0, turbulence.x, turbulence.y);
  ivec2 middle = lattice_noise(x, y, 1, turbulence.x >> 1, turbulence.y - 1);
  ivec2 fine = lattice_noise(x, y, 2, turbulence.x >> 2, turbulence.y - 2);
  return ivec2(coarse.x + middle.x + fine.x, coarse.y + middle.y + fine.y);
}

// Along one axis: `whole` texels, |whole| < 2^26, and `part` 1/256 texel from the start of repetition `tile` to a
// repetition and an offset in 1/256 texel.
uvec2 wrapped_axis(uint tile, int whole, int part, int side) {
  uint n = uint(side);
  uint repetitions = 67108864u / n + 1u;
  uint moved = uint(whole + (part >> 8)) + repetitions * n;
  return uvec2(tile + moved / n - repetitions, (moved % n) * 256u + uint(part & 255));
}

// Where the structure of a texel of the picture is taken from.
Position deformed_position(Texel at) {
  int i = int((at.tile.x - deform_from_tile.x) * uint(tile_size.x) + uint(at.p.x) - uint(deform_from.x));
  int j = int((at.tile.y - deform_from_tile.y) * uint(tile_size.y) + uint(at.p.y) - uint(deform_from.y));
  ivec2 x_i = scaled(deform_matrix.x, i);
  ivec2 x_j = scaled(deform_matrix.y, j);
  ivec2 y_i = scaled(deform_matrix.z, i);
  ivec2 y_j = scaled(deform_matrix.w, j);
  int rest_x = deform_to.z + x_i.y + x_j.y;
  int rest_y = deform_to.w + y_i.y + y_j.y;
  ivec2 stirred = turbulence_at(at);
  uvec2 x = wrapped_axis(deform_to_tile.x, deform_to.x + x_i.x + x_j.x, (rest_x >> 8) + stirred.x, tile_size.x);
  uvec2 y = wrapped_axis(deform_to_tile.y, deform_to.y + y_i.x + y_j.x, (rest_y >> 8) + stirred.y, tile_size.y);
  Position position;
  position.tile = uvec2(x.x, y.x);
  position.offset = ivec2(int(x.y), int(y.y));
  return position;
}

// Structure and masks between four texels of the infinite texture, the noise of the texel itself.
vec4 deformed_value(sampler2D plane, Texel at) {
  Footprint footprint = footprint_at(deformed_position(at));
  vec4 structure = footprint_value(plane, footprint);
  if (noise_step == 0) return structure;
  uvec4 weights = blended_weights(source_weights(footprint.upper_left), source_weights(footprint.upper_right),
                                  source_weights(footprint.lower_left), source_weights(footprint.lower_right),
                                  footprint.fraction);
  return with_noise(structure, weights, noise_place(at));
}

vec4 deformed_footprint(sampler2D plane, Position at) {
  Position corner = upper_left_center(at);
  Texel texel = texel_at(corner);
  Texel lower = below(texel);
  return bilinear(deformed_value(plane, texel), deformed_value(plane, right_of(texel)), deformed_value(plane, lower),
                  deformed_value(plane, right_of(lower)), ivec2(corner.offset.x & 255, corner.offset.y & 255));
}
