// The bounding box of a shape on the torus, as it grows texel by texel or box by box.
#pragma once

#include <algorithm>

#include "libbake/base/torus.h"

namespace texbake {

/// `low` is a corner in 0 … size−1, `extent` the number of columns and rows from there on, across the border of the
/// tile if need be; an extent of 0 is the empty box. Boxes of a shape that is under half the tile are exact.
struct TorusBox {
  V2i low{0, 0};
  V2i extent{0, 0};
  bool operator==(const TorusBox&) const = default;
};

/// The smaller of the two arcs of a circle of `n` texels that hold [low, low + extent) and [a, a + length).
inline void join_arcs(int& low, int& extent, int a, int length, int n) {
  const int ahead = a >= low ? a - low : a - low + n;  // steps from the first arc's start forward to the second's
  const int behind = ahead == 0 ? 0 : n - ahead;       // and back
  const int forward = std::max(extent, ahead + length);
  const int backward = std::max(length, behind + extent);
  if (backward < forward) {
    low = a;
    extent = backward;
  } else {
    extent = forward;
  }
}

/// The smallest box that holds both.
inline TorusBox joined(TorusBox a, const TorusBox& b, V2i size) {
  if (a.extent.x == 0) return b;
  if (b.extent.x == 0) return a;
  join_arcs(a.low.x, a.extent.x, b.low.x, b.extent.x, size.x);
  join_arcs(a.low.y, a.extent.y, b.low.y, b.extent.y, size.y);
  return a;
}
inline TorusBox joined(const TorusBox& box, V2i texel, V2i size) {
  return joined(box, TorusBox{texel, V2i(1, 1)}, size);
}

inline bool fits(const TorusBox& box, V2i limit) { return box.extent.x <= limit.x && box.extent.y <= limit.y; }

}  // namespace texbake
