// Bounds the impact of turned and scaled contents from below, for all translations at once, by correlation.
// Based on: Vanhoey et al. 2013, eq. 2-3; Guingo et al. 2017, §4.
#pragma once

#include <array>
#include <complex>
#include <span>

#include "libbake/base/image.h"
#include "libbake/content/cell_grid.h"
#include "libbake/content/class_distances.h"
#include "libbake/content/content.h"

namespace texbake {

/// A texel of the dilated border of a patch.
struct BorderTexel {
  V2i offset{0, 0};  ///< from the center of the patch
  int class_idx = 0;
};

/// A tile on at most 256 × 256 cells, each with the shares of the classes in it.
class TurnedBound {
 public:
  TurnedBound(ImageView<const uint8_t> classes, const ClassDistances& distances);

  const CellGrid& grid() const { return grid_; }

  /// Σ δ² over `border`, a lower bound of Σ E (δ of a texel itself is one of the 49 terms), for contents that bring
  /// each cell to the center of the patch: turned as `turn`, and by another half of a turn. As exact as the cells are
  /// fine; where a cell is a texel, up to the rounding of float and of turned offsets.
  std::array<Image<float>, 2> bounds(std::span<const BorderTexel> border, const Content& turn) const;

 private:
  using Spectrum = Image<std::complex<float>>;
  Image<float> weights(std::span<const BorderTexel> border, const Content& turn, int class_idx) const;

  CellGrid grid_;
  ClassDistances distances_;
  std::vector<Spectrum> shares_;  // of each class
};

}  // namespace texbake
