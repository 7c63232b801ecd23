// Can a picture be tiled: how the step across its wrap compares with the steps inside it.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// The wrap of one axis. A step is the mean absolute difference between two neighboring columns (or rows). Where the
/// side is a multiple of 8, the wrap is compared with the steps at multiples of 8 alone: JPEG makes steps there, and
/// the wrap is one of them. Ratios are at most 1000; a picture that is constant along the axis has ratios of 1.
struct AxisSeam {
  double ratio = 1;             ///< T: step across the wrap / mean step inside
  double coarse_ratio = 1;      ///< the same of 8 × 8 means: reacts to shade, ignores grain
  double share_of_largest = 1;  ///< step across the wrap / largest step inside
  double share_of_beside = 1;   ///< step across the wrap / the larger of the two steps next to it

  /// Either the wrap is hardly more than a usual step, fine and coarse; or a true edge runs along it (mortar, a
  /// stripe): no step is larger than the largest inside, and the edge goes on beside it, as edges of photographs do.
  bool tiles() const;
};
inline constexpr double kLargestSeamRatio = 1.5;         ///< beyond it, T is neither good (1.15) nor doubtful
inline constexpr double kLargestCoarseSeamRatio = 1.35;  ///< pictures made seamless have up to 1.25, crops from 1.3
inline constexpr double kLargestShareOfBeside = 1.5;     ///< true edges have up to 1.25, crops of patterns from 1.9

struct SeamMeasure {
  AxisSeam x;  ///< the last column against the first
  AxisSeam y;  ///< the last row against the first
  bool tiles() const { return x.tiles() && y.tiles(); }
};

/// Colors in linear Rec.709, compared by their Euclidean distance in sRGB codes, as the eye and JPEG see them. (In
/// CIELUV the chroma noise of JPEG in dark places outweighs the seam.)
SeamMeasure measure_seam(ImageView<const V3f> linear);
/// One channel of data, compared by absolute difference.
SeamMeasure measure_seam(ImageView<const float> values);
/// Three channels of data, such as normals, compared by Euclidean distance.
SeamMeasure measure_vector_seam(ImageView<const V3f> values);

}  // namespace texbake
