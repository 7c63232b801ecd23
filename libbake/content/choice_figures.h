// Judges a choice of contents before anything is drawn.
// Based on: quality measures of repetition from the contents alone, without rendering.
#pragma once

#include "libbake/base/image.h"
#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

struct ChoiceFigures {
  double repetition_near = 0;  ///< G expected with the contents, σ = 0: 1 periodic, about 1/N_t at best
  double repetition_far = 0;   ///< the same, σ = 1/16 of the tile's shorter side
  double use_deviation = 0;    ///< standard deviation of how often a texel is used / its mean
};

/// G = |B mean z|² / mean |B z|², where z is the infinite texture less the tile's mean, averaged over all draws of
/// contents, and B the low-pass: none for `repetition_near`, that of far_view.h for `repetition_far`. A tile of one
/// color has G = 0. `base_luv` is the base in CIELUV.
ChoiceFigures choice_figures(const ContentTable& table, ImageView<const V3f> base_luv, const Partition& patches);

}  // namespace texbake
