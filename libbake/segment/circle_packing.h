// Circles of similar size packed on the torus: where patches will lie, before fragments give them their borders.
// Based on: Vanhoey et al. 2013, §5.2, "Patch map".
#pragma once

#include <Imath/ImathVec.h>

#include <cstdint>
#include <vector>

#include "libbake/base/torus.h"

namespace texbake {

using Imath::V2d;

struct CirclePacking {
  V2i size;                   ///< of the tile
  V2d cell;                   ///< width and height of one circle's share of the tile, in texels: the unit of distance
  std::vector<V2d> centers;   ///< in 0 … size; texel (x, y) has its center at (x + 0.5, y + 0.5)
  std::vector<double> power;  ///< of each circle, in cells²; 0 until they are balanced

  /// Squared distance of `point` from the center of circle `i`, the shortest on the torus, in cells².
  double squared_distance(V2d point, size_t i) const;
};

/// Width and height of one of `count` equal shares of the tile: square where its shape allows, narrower along the
/// shorter axis of a long tile so that a share stays well under half of it.
V2d packing_cell(V2i size, int count);

/// `count` circles, the first over the corner of the tile, the others thrown by chance, each as far from the earlier
/// ones as the best of several throws, and then pushed apart. `stream` gives other throws for the same seed.
CirclePacking pack_circles(V2i size, int count, uint32_t seed, uint32_t stream = 0);

/// Changes the powers until the points, each given to the circle of least squared distance minus power, are shared
/// evenly by weight. Circles of greater power are larger.
CirclePacking balance(CirclePacking packing, const std::vector<V2d>& points, const std::vector<uint32_t>& weights);

}  // namespace texbake
