// The tile as it looks from afar, on a coarse grid of cells: what the balanced choice compares.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Colours low-passed by a Gaussian of 1/16 of the tile's shorter side, less their mean, on about 64 cells along that
/// side (fewer on smaller tiles). Cell i of n covers texels ⌊i·size/n⌋ … ⌊(i+1)·size/n⌋ − 1.
struct LowPassed {
  V2i size_px{0, 0};  ///< of the tile
  Image<V3f> color;
  double energy = 0;  ///< mean squared length of `color`

  V2i cells() const { return {color.width(), color.height()}; }
  /// The texel in the middle of a cell.
  V2i middle_px(V2i cell) const {
    return {(2 * cell.x + 1) * size_px.x / (2 * cells().x), (2 * cell.y + 1) * size_px.y / (2 * cells().y)};
  }
  /// A translation in the nearest whole cells, 0 … cells − 1.
  V2i shift(V2i translation) const;
};

LowPassed low_passed(ImageView<const V3f> luv);

}  // namespace texbake
