// A tile cut into cells of nearly equal size, for what need not be known to the texel.
#pragma once

#include <algorithm>

#include "libbake/base/torus.h"

namespace texbake {

/// Cell i of n covers the texels x with ⌊x·n/size⌋ = i, one or more, along each axis.
struct CellGrid {
  V2i size_px{1, 1};  ///< of the tile
  V2i cells{1, 1};    ///< at most size_px

  /// About square cells, `along_shorter` of them along the shorter side, fewer where it has fewer texels.
  static CellGrid of(V2i size_px, int along_shorter) {
    const int side = std::min(size_px.x, size_px.y);
    const auto cells_along = [&](int n) { return std::min(n, (n * along_shorter + side / 2) / side); };
    return {size_px, {cells_along(size_px.x), cells_along(size_px.y)}};
  }

  V2i cell_of(V2i p) const { return {p.x * cells.x / size_px.x, p.y * cells.y / size_px.y}; }
  V2i first_px(V2i cell) const {
    return {(cell.x * size_px.x + cells.x - 1) / cells.x, (cell.y * size_px.y + cells.y - 1) / cells.y};
  }
  V2i middle_px(V2i cell) const { return (first_px(cell) + first_px(cell + V2i(1, 1))) / 2; }
};

}  // namespace texbake
