// Region growing: fragments before cleaning, each of one class and of little contrast.
// Based on: Vanhoey et al. 2013, §5.1, "Region growing".
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/color/palette.h"

namespace texbake {

struct GrowthLimits {
  float threshold = 1;   ///< τ, in ΔE
  int max_area_px = 1;   ///< a fragment is closed when it has this many texels
  V2i max_extent{1, 1};  ///< no fragment's bounding box on the torus is wider or higher
  uint32_t seed = 1;     ///< of every choice
};

/// Stands for the index of a texel that no fragment has.
inline constexpr uint32_t kFree = 0xffffffffu;

/// What growth leaves: every texel in exactly one fragment, all of whose texels have the same index.
struct Growth {
  Image<uint32_t> idx;        ///< 0 … count−1, in the order in which the fragments were seeded
  std::vector<size_t> seeds;  ///< row-major position of the first texel of each fragment
  int count() const { return static_cast<int>(seeds.size()); }
};

/// The first seed is a random texel; every further one is a random texel among those that are free and border a
/// fragment. From its seed a fragment F takes free texels of its class with |v(p) − mean of v over F| < τ, one picked
/// by chance after the other among those that border it: that makes it round, and irregular where only the maximum area
/// ends it; breadth first it would end there in straight lines, nearest to the mean first it would run along veins.
/// Texels that it refused are asked again when all have been asked, since the mean has moved: the one nearest to the
/// mean first, the lowest position among equals. It is closed when none is left, or at the maximum area.
Growth grow(const Image<uint8_t>& index, const Image<float>& variation, const GrowthLimits& limits);

}  // namespace texbake
