// The lattice of a near-regular texture: bricks, weaves, tiles. Contents moved along it keep mortar on mortar.
// Based on: Liu, Collins and Tsin 2004, "A computational model for periodic pattern perception": a lattice shows as
// peaks of the autocorrelation.
#pragma once

#include <optional>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

struct TranslationLattice {
  std::vector<V2i> translations;  ///< −size/2 … (size−1)/2, the strongest first; the identity is not among them
  double correlation = 0;         ///< autocorrelation at the first of them, 0 … 1
};

/// The lattice of a tile in CIELUV, or nothing where it shows none. The tile is high-passed first (a Gaussian of 1/16
/// of the shorter side is taken away), so that shading makes no peaks. It shows a lattice where its autocorrelation has
/// a peak of at least 0.15 and at least three pairs of peaks of 0.4 of that and above can be reached from the identity
/// by steps along two of them: one repeated detail, as left by retouching, makes a single pair. On fourteen photographs
/// bricks (0.27) and a weave (0.82) have a lattice; the others stay below 0.12 or have one pair.
std::optional<TranslationLattice> find_lattice(ImageView<const V3f> luv);

/// Which translations lie within `radius_px` (Chebyshev) of one of the lattice: 1, else 0. By translation, 0 … size−1.
Image<uint8_t> near_lattice(const TranslationLattice& lattice, V2i size, int radius_px);

}  // namespace texbake
