// A bundle's tile at a fraction of its size, so that measuring a large one takes bounded time and memory.
#pragma once

#include "libbake/planes/prepare.h"

namespace texbake {

/// What the evaluator needs to draw the reduced tile.
struct ReducedTile {
  int factor = 1;
  Image<V3f> base;
  std::optional<PatchMap> patches;
  std::optional<ContentTable> contents;
  int soft_border_px = 0;
  std::vector<Image<float>> masks;
  std::vector<Image<V3f>> noise_tiles;
  int noise_step = 0;
  NoiseSpace noise_space = NoiseSpace::root;

  EvaluatorInput input() const;
};

/// The least factor that divides both sides of `size` and leaves none above `largest_side`; 1 where there is none.
int reduction_to(V2i size, int largest_side);
/// The same for `input`: a power of two where it has noises, whose tiles stay powers of two that way.
int reduction_to(const EvaluatorInput& input, int largest_side);

/// Colors are means of factor × factor blocks; patches and owners are taken from the middle of each block;
/// translations and centers are divided and rounded. Masks are taken from the middle of blocks, noises are means.
/// `factor` divides both sides of the base and of the noises.
ReducedTile reduced_tile(const EvaluatorInput& input, int factor);

}  // namespace texbake
