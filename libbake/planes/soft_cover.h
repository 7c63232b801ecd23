// How much each patch counts at every texel where borders of patches are soft.
#pragma once

#include <vector>

#include "libbake/planes/level_cover.h"

namespace texbake {

/// The patches of every texel, its own first; and of each entry its weight, the weights of a texel having the sum 1.
struct SoftCover {
  LevelCover cover;
  std::vector<float> weights;
};

/// A weight is the share of the patch in the texels around, counted with (w − |dx|) (w − |dy|) for distances below
/// w = `width_px` ≥ 1: borders change over 2 w − 1 texels, and 1 leaves them hard. The sides are at least 8 w.
SoftCover soft_cover(ImageView<const glsl::PatchTexel> patch_plane, int width_px);

}  // namespace texbake
