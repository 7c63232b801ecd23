// How visible the seams are where contents meet.
#pragma once

#include <cstdint>
#include <optional>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Seam pairs against two references: "all" neighbors of the exemplar, and the exemplar's "own" difference across the
/// same pair of texels before any exchange. Patch borders follow contrast on purpose, so "own" is the verdict.
struct Seams {
  size_t pair_count = 0;
  double auc_all = 0.5;  ///< P(d_seam > d_reference), ties count ½: 0.5 is invisible
  double auc_own = 0.5;
  double tail_all = 0;  ///< P(d_seam > 95th percentile of the reference): 0.05 is invisible
  double tail_own = 0;
  double run_px = 0;  ///< Σ len² / Σ len over 8-connected seam texels above that percentile of "all"
};

/// Which texels of the exemplar are neighbors.
enum class Adjacency {
  torus,  ///< the tile goes on across its wrap
  plane,  ///< the wrap counts as a seam too: how periodic tiling is judged
};

struct SeamOptions {
  /// Label of what each output texel belongs to, of the size of `source`, or empty. Texels of one label make no seam,
  /// also where a turned content takes them from texels that are not neighbors.
  ImageView<const uint32_t> shape = {};
  Adjacency adjacency = Adjacency::torus;
  /// What the rendering shows, CIELUV, of the size of `source`; empty where that is the exemplar at the source. Soft
  /// borders show blends.
  ImageView<const V3f> shown = {};
};

/// `source(x, y)` is the texel of the exemplar that the rendering shows at (x, y), whose own place in the tile is
/// (x, y) mod tile. Two 4-neighbors are a seam pair where their sources are not neighbors in the same way. Nothing
/// when there is no seam pair.
std::optional<Seams> seams(ImageView<const V3f> exemplar_luv, ImageView<const V2i> source,
                           const SeamOptions& options = {});

/// What a texel of the rendering has to do with seams.
enum class SeamTexel : uint8_t {
  none,
  hidden,   ///< at a seam pair whose difference is usual across such pairs before any exchange
  visible,  ///< at a seam pair above the 95th percentile of "own"
};
/// For every texel of `source`, the worst of its pairs.
Image<SeamTexel> seam_texels(ImageView<const V3f> exemplar_luv, ImageView<const V2i> source,
                             const SeamOptions& options = {});

}  // namespace texbake
