// Judges a choice of contents before anything is drawn.
// Based on: quality measures of repetition from the contents alone, without rendering.
#pragma once

#include "libbake/base/image.h"
#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

struct ChoiceFigures {
  double repetition_near = 0;  ///< G predicted from the contents, σ = 0: 1 periodic, about 1/N_t at best
  double repetition_far = 0;   ///< the same, σ = 1/16 of the tile's shorter side
  double use_deviation = 0;    ///< standard deviation of how often a texel is used / its mean
};

/// G_σ = Σ_P Σ_{x∈P} |mean_c z_c(x)|² / Σ_P Σ_{x∈P} mean_c |z_c(x)|², where c runs over the contents of P, the identity
/// among them, and z_c(x) is the colour at the source of x, low-passed as it is seen there, less its mean over the
/// tile. A tile of one colour has G = 0. `base_luv` is the base in CIELUV.
ChoiceFigures choice_figures(const ContentTable& table, ImageView<const V3f> base_luv, const Partition& patches);

}  // namespace texbake
