// The impact across a border when the patches on both its sides have exchanged their contents, as at run time.
// Based on: Vanhoey et al. 2013, eq. 2-3, which see only the original neighbor.
#pragma once

#include "libbake/content/class_distances.h"
#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

/// Impact over all N_t² pairs of contents of all pairs of patches that touch, in ΔE⁴.
struct PairImpact {
  double mean = 0;
  double worst = 0;
};

/// E of eq. 3 with δ(p) = ‖C(source of p in a) − C(source of p in b)‖², a the content of the one patch and b of the
/// other, averaged over the texels of the two patches within 2 texels of the border texels of either: where b is the
/// identity, eq. 2 on a border one texel wider.
PairImpact pair_impact(ImageView<const uint8_t> classes, const ClassDistances& distances, const Partition& patches,
                       const ContentTable& table);

}  // namespace texbake
