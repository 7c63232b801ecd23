// The tile as it looks from afar, on a coarse grid of cells: what the balanced choice compares.
#pragma once

#include "libbake/base/image.h"
#include "libbake/content/cell_grid.h"

namespace texbake {

/// Colours low-passed by a Gaussian of 1/16 of the tile's shorter side, less their mean, on about 64 cells along that
/// side (fewer on smaller tiles).
struct LowPassed {
  CellGrid grid;
  Image<V3f> color;   ///< of each cell
  double energy = 0;  ///< mean squared length of `color`

  /// The colour of the cell in which texel `p` of the tile lies.
  const V3f& at(V2i p) const {
    const V2i cell = grid.cell_of(p);
    return color(cell.x, cell.y);
  }
};

/// `scale` is that of the contents in which the tile is seen: what is shown smaller is low-passed wider.
LowPassed low_passed(ImageView<const V3f> luv, float scale = 1.0f);

}  // namespace texbake
