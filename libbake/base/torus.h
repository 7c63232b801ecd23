// Arithmetic on the torus: coordinates that wrap at the border of the tile.
#pragma once

#include <Imath/ImathVec.h>

namespace texbake {

using Imath::V2f;
using Imath::V2i;
using Imath::V3f;

/// `x` modulo `n`, in 0 … n−1 for negative `x` too.
inline int wrap(int x, int n) {
  const int r = x % n;
  return r < 0 ? r + n : r;
}
inline V2i wrap(V2i p, V2i size) { return {wrap(p.x, size.x), wrap(p.y, size.y)}; }

/// The shortest signed step from 0 to `d` on a circle of `n` texels: in −n/2 … (n−1)/2.
inline int shortest(int d, int n) { return wrap(d + n / 2, n) - n / 2; }
inline V2i shortest(V2i d, V2i size) { return {shortest(d.x, size.x), shortest(d.y, size.y)}; }

/// The four neighbors that share an edge, in the fixed order in which every stage visits them.
inline constexpr int kNeighborX[4] = {1, 0, -1, 0};
inline constexpr int kNeighborY[4] = {0, 1, 0, -1};

}  // namespace texbake
