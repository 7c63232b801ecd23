// How visible the seams are where contents meet.
#pragma once

#include <optional>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Seam pairs against two references: "all" neighbours of the exemplar, and the exemplar's "own" difference across the
/// same pair of texels before any exchange. Patch borders follow contrast on purpose, so "own" is the verdict.
struct Seams {
  size_t pair_count = 0;
  double auc_all = 0.5;  ///< P(d_seam > d_reference), ties count ½: 0.5 is invisible
  double auc_own = 0.5;
  double tail_all = 0;  ///< P(d_seam > 95th percentile of the reference): 0.05 is invisible
  double tail_own = 0;
  double run_px = 0;  ///< Σ len² / Σ len over 8-connected seam texels above that percentile of "all"
};

/// `source(x, y)` is the texel of the exemplar that the rendering shows at (x, y), whose own place in the tile is
/// (x, y) mod tile. Two 4-neighbours are a seam pair where their sources are not neighbours in the same way on the
/// torus. Nothing when there is no seam pair.
std::optional<Seams> seams(ImageView<const V3f> exemplar_luv, ImageView<const V2i> source);

}  // namespace texbake
