// Chooses each patch's contents among its candidates, so that from afar no grid shows and the exemplar is used evenly.
// Based on: Vanhoey et al. 2013, §5.2 (least impact). The balanced rule is our own: contents that match a border also
// share the low frequencies of what they replace, so that least impact alone keeps the grid of tiles visible from afar.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

/// Weights of the balanced choice, in units of one patch's balance term (about 0.2 … 1).
struct ChoiceWeights {
  double use = 1.0;      ///< of the variance of how often texels are used, relative to their mean use squared
  double impact = 0.02;  ///< of a content's impact relative to the mean of its patch's candidates: where all else is
                         ///< equal
  double steps = 2.0;    ///< of how visible the borders are with contents on both sides, see border_steps.h. On six
                         ///< photographs own AUC fell by 0.008 to 0.015, and repetition from afar by an eighth to two
                         ///< fifths, since less weighs on impact; from 3 on a strong shade keeps its grid
};

/// For each patch the contents to choose from, the identity apart, least impact first.
using ContentCandidates = std::vector<std::vector<Content>>;

/// For each patch the numbers of its chosen candidates, `wanted` of them.
using ChosenCandidates = std::vector<std::vector<int>>;

/// The first `wanted` candidates of each patch: the least impact.
ChosenCandidates choose_least_impact(const ContentCandidates& candidates, int wanted);

/// Balanced: minimises, over all patches together,
///   Σ_P [ |mean_c z_c|² / mean_c |z_c|²  +  ½ |log(mean_c |z_c|² / tile energy)|  +  impact · Σ_c I_c / mean I
///         + steps · mean visibility of P's borders ]
///   + use · P · variance of use / mean use²
/// where c runs over the identity and the chosen contents and z_c is what the patch shows with c, low-passed by 1/16 of
/// the tile's smaller side, less the tile's mean. Starts greedily and then exchanges one content at a time, patches in
/// an order drawn from `seed`, until nothing improves. `base_luv` is the base in CIELUV.
ChosenCandidates choose_balanced(const ContentCandidates& candidates, int wanted, ImageView<const V3f> base_luv,
                                 const Partition& patches, uint32_t seed, const ChoiceWeights& weights = {});

}  // namespace texbake
