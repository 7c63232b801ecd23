// The impact across a border when the patches on both its sides have exchanged their contents, as at run time.
// Based on: Vanhoey et al. 2013, eq. 2-3, which see only the original neighbour.
#pragma once

#include <vector>

#include "libbake/base/image.h"
#include "libbake/content/class_distances.h"

namespace texbake {

/// Impact over all N_t² pairs of contents of all pairs of patches that touch, in ΔE⁴.
struct PairImpact {
  double mean = 0;
  double worst = 0;
};

/// E of eq. 3 with δ(p) = ‖C(p + t_a) − C(p + t_b)‖², a the content of the one patch and b of the other, averaged over
/// the texels of the two patches within 2 texels of the border texels of either: where b is the identity, eq. 2 on a
/// border one texel wider. `translations` holds, for each patch, those of its contents; none is turned.
PairImpact pair_impact(ImageView<const uint8_t> classes, const ClassDistances& distances,
                       ImageView<const uint32_t> patch_idx, const std::vector<std::vector<V2i>>& translations);

}  // namespace texbake
