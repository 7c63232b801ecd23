// Fragment cleaning: what is too small is dissolved into its neighbors.
// Based on: Vanhoey et al. 2013, §5.1, "Fragment cleaning".
#pragma once

#include "libbake/segment/grow.h"

namespace texbake {

struct CleaningLimits {
  int min_area_px = 1;   ///< smaller fragments are emptied
  int max_area_px = 1;   ///< a fragment of this area takes texels only where no other neighbor can
  V2i max_extent{1, 1};  ///< and none that would make its bounding box larger than this
};

/// While a fragment is smaller than the minimum, the smallest (the lowest index among equals) is emptied. Its texels go
/// from the border inward, each to the neighboring fragment whose mean color is nearest in CIELUV. A texel that no
/// neighbor can take stays in a fragment of its own piece. `luv` is the color of each texel. The result numbers the
/// fragments by their first texel in row order; its `seeds` are those of the fragments that remain.
Growth clean(Growth growth, const Image<V3f>& luv, const CleaningLimits& limits);

}  // namespace texbake
