// The hash that draws the content of a patch. One text for GLSL 330 core, GLSL ES 3.00 and C++20.
// Based on: O'Neill 2014, PCG32 RXS M XS, as a permutation of 32-bit integers; semantics in README.md.

// One step of a linear congruential generator, its output permuted: a bijection of the 32-bit integers.
uint pcg(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// 32 random bits of patch `patch_idx` in the repetition `tile` of the tile.
uint content_hash(uint patch_idx, uvec2 tile, uint content_seed) {
  return pcg(patch_idx + pcg(tile.x + pcg(tile.y + pcg(content_seed))));
}
