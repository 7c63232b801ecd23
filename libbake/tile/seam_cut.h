// The cut of least visible error through a strip in which two pictures overlap.
// Based on: Efros and Freeman 2001, "Image quilting", §2.1; cost of a seam between texels: Kwatra et al. 2003, §3,
// eq. 1.
#pragma once

#include <vector>

#include "libbake/base/image.h"

namespace texbake {

/// What the two ends of a cut have to do with each other.
enum class CutEnds {
  open,    ///< the cut starts and ends anywhere
  closed,  ///< row 0 follows the last row: the strip is a ring
};

/// A cut runs down a strip: in row y, the columns below `column[y]` show the first picture and the others the second.
struct SeamCut {
  std::vector<int> column;  ///< for each row, 1 … width − 1
  double cost = 0;
};

/// The cut of least cost, found exactly. `mismatch` (at least two columns, at least one row) says how much the two
/// pictures differ at each texel of the strip; each pair of 4-neighbors that show different pictures costs the sum of
/// their two mismatches. Of cuts of equal cost, one is chosen by a fixed rule.
SeamCut minimum_cut(ImageView<const float> mismatch, CutEnds ends);

/// The cost of a given cut, by its definition.
double cut_cost(ImageView<const float> mismatch, const std::vector<int>& column, CutEnds ends);

}  // namespace texbake
