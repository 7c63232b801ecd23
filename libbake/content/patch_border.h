// The texels over which the impact of a content is averaged: the border of a patch, dilated.
// Based on: Vanhoey et al. 2013, §5.2, dil(∂P) of eq. 2.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

inline constexpr int kBorderDilation = 2;  ///< Chebyshev radius, texels

/// dil(∂P) of every patch, as the set of patches at each texel.
struct PatchBorders {
  int patch_count = 0;
  Image<uint32_t> set_idx;                  ///< which of `sets` holds the patches whose dilated border has this texel
  std::vector<std::vector<uint32_t>> sets;  ///< distinct sets of patches, ascending; sets[0] is empty
  std::vector<size_t> texel_counts;         ///< |dil(∂P)| of each patch
};

/// ∂P holds the texels of P with a 4-neighbor outside P; it is dilated on both sides, on the torus. `patch_idx` holds
/// 0 … patch_count−1.
PatchBorders patch_borders(ImageView<const uint32_t> patch_idx, int patch_count);

}  // namespace texbake
