// Noise that repeats with the tile, the same on every machine.
// Based on: Perlin 2002, "Improving noise".
#pragma once

#include <cstdint>

#include "libbake/base/torus.h"

namespace texbake {

/// Gradient noise in about −1 … 1 at `p` in units of the tile (0 … 1 is one tile), with `cells` lattice cells across
/// it. Any p; repeats with the tile.
float gradient_noise(V2f p, int cells, uint32_t seed);

/// Sum of `octaves` of it, each twice as fine and half as strong; in about −1 … 1.
float fractal_noise(V2f p, int cells, int octaves, uint32_t seed);

/// A number in 0 … 1 that `key` and `seed` decide.
float hash_01(uint32_t key, uint32_t seed);

}  // namespace texbake
