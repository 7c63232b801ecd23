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

/// Weights of the balanced choice. Measured with eight contents on photographs of 512², against a choice that balanced
/// every patch by itself: the amplitude of the grid seen from afar fell from 0.37 … 1.1 ΔE to 0.01 … 0.39, and what is
/// larger than an eighth of the tile has 0.91 … 0.99 of its contrast (sand 1.17) instead of 0.71 … 0.87; seams as
/// before.
struct ChoiceWeights {
  double balance = 8.0;         ///< of what repeats with the tile from afar, for each patch
  double energy = 0.5;          ///< of how far a patch's contents are from its share of the tile's contrast from afar
  double farther_energy = 1.0;  ///< the same from twice as far: the largest shapes
  double use = 1.0;             ///< of the variance of how often texels are used, relative to their mean use squared
  double impact = 0.02;  ///< of a content's impact relative to the mean of its patch's candidates: where all else is
                         ///< equal
  double steps = 2.0;    ///< of how visible the borders are with contents on both sides, see border_steps.h
};

/// For each patch the contents to choose from, the identity apart, least impact first.
using ContentCandidates = std::vector<std::vector<Content>>;

/// For each patch the numbers of its chosen candidates, `wanted` of them.
using ChosenCandidates = std::vector<std::vector<int>>;

/// The first `wanted` candidates of each patch: the least impact.
ChosenCandidates choose_least_impact(const ContentCandidates& candidates, int wanted);

/// Balanced: minimizes, over all P patches together,
///   balance · P · |B Σ_P mean_c f_c|² / E
///   + energy · Σ_P |log(mean_c |B f_c|² / (share_P · E))|  +  farther_energy · the same with another B
///   + impact · Σ_P Σ_c I_c / mean I  +  steps · Σ_P mean visibility of P's borders
///   + use · P · variance of use / mean use²
/// where c runs over the identity and the chosen contents of P, f_c is what P shows with c, B the low-pass `far` of
/// far_view.h (`farther` in the third term), E the tile's energy through it, and share_P that of the tile's area; to
/// all energies those of 0.2 ΔE are added, which are not seen. The first term is the square of the grid's amplitude;
/// the next two keep large shapes from being washed out. Starts greedily and then exchanges one content at a time,
/// patches in an order drawn from `seed`, until nothing improves. `base_luv` is the base in CIELUV.
ChosenCandidates choose_balanced(const ContentCandidates& candidates, int wanted, ImageView<const V3f> base_luv,
                                 const Partition& patches, uint32_t seed, const ChoiceWeights& weights = {});

}  // namespace texbake
