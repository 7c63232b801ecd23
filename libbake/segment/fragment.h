// Fragments: small regions of one color class, the atoms of patches and of color transfer.
// Based on: Vanhoey et al. 2013, §5.1.
#pragma once

#include <optional>

#include "libbake/base/options.h"
#include "libbake/base/progress.h"
#include "libbake/color/palette.h"
#include "libbake/segment/partition.h"

namespace texbake {

struct FragmentOptions {
  std::optional<float> threshold{};  ///< τ
  std::optional<int> min_area_px{};
  std::optional<int> max_area_px{};
  std::optional<float> denoise_px{};
  uint32_t seed = 1;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.threshold, Field{.name = "threshold",
                                .unit = "ΔE",
                                .min = 0.01,
                                .max = 1000,
                                .help = "contrast at which a fragment stops growing (τ)",
                                .auto_help = "derived from the spread of the variation coordinate"});
    visit(self.min_area_px, Field{.name = "min-area",
                                  .unit = "px",
                                  .min = 1,
                                  .max = 1e8,
                                  .help = "minimum area of a fragment; smaller ones are dissolved into their neighbors",
                                  .auto_help = "from the size of the tile"});
    visit(self.max_area_px, Field{.name = "max-area",
                                  .unit = "px",
                                  .min = 4,
                                  .max = 1e8,
                                  .help = "maximum area of a fragment, at which it stops growing",
                                  .auto_help = "from the size of the tile"});
    visit(self.denoise_px, Field{.name = "denoise",
                                 .unit = "px",
                                 .min = 0,
                                 .max = 64,
                                 .help = "sigma of the Gaussian that removes grain from the picture in which borders "
                                         "are found; 0: fragments grow on the classes unsmoothed",
                                 .auto_help = "derived from the size of the tile: 1.5 px at 1024 x 1024"});
    visit(self.seed, Field{.name = "seed", .min = 0, .max = 4294967295.0, .help = "random seed of the growth order"});
  }
};

struct Fragment {
  uint32_t class_idx = 0;  ///< color class of the seed
  V3f mean_color{0};       ///< mean of the base over the fragment, linear Rec.709, half-exact
};

struct FragmentMap {
  Partition partition;
  std::vector<Fragment> fragments;  ///< one for each shape of the partition
};

/// The options with every automatic value replaced by the one that `fragment` will use: what provenance records. Throws
/// Error(usage) where the smallest area is above the largest.
FragmentOptions resolve(const FragmentOptions& options, const PrincipalVariation& colors);

/// Grows and cleans fragments on the torus (grow.h, clean.h), numbered by their first texel in row order; none wider or
/// higher than a quarter of the tile. `base` is the picture behind `colors`, same size, linear Rec.709. Throws
/// Error(infeasible) for a tile of less than 3 texels on an axis: no shape is under half of it.
FragmentMap fragment(const PrincipalVariation& colors, ImageView<const V3f> base, const FragmentOptions& options = {},
                     const Progress& progress = {});

}  // namespace texbake
