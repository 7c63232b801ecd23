// Joins a picture with itself along a cut, and levels the shade that still differs across it.
// Based on: Efros and Freeman 2001, §2.1; the leveling is a membrane as in Pérez et al. 2003, of the smoothed
// mismatch.
#pragma once

#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/tile/seam_cut.h"

namespace texbake {

/// Where a picture meets itself: its columns begin … begin + overlap − 1 and those `period` columns further on.
struct Seam {
  int begin = 0;
  int period = 0;
  int overlap = 0;  ///< at most `period`
  CutEnds ends = CutEnds::open;
  std::vector<int> column;  ///< the cut: in row y, the columns below column[y] show what is `period` further on
};

/// `period` columns of `image`, which has a row for each row of the cut. Detail is cut hard. What differs in the same
/// way along a stretch of the cut (a shade, an exposure) is spread over both sides, half on each, with a Gaussian of
/// σ = min(overlap / 5, 16) texels: where the cut joins equal texels, or errors cancel, nothing changes. Values stay
/// between the least and the greatest of each channel.
Image<V3f> join_along_x(ImageView<const V3f> image, const Seam& seam);
Image<float> join_along_x(ImageView<const float> image, const Seam& seam);

}  // namespace texbake
