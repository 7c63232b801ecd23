// Finds the principal variation colour space of an exemplar.
// Based on: Vanhoey et al. 2013, §4: K-means with the distance to the line of eq. 1, from octree-quantised starts.
#pragma once

#include <optional>

#include "libbake/base/options.h"
#include "libbake/base/progress.h"
#include "libbake/color/palette.h"

namespace texbake {

struct ConvertOptions {
  std::optional<int> classes;  ///< K
  float height_weight = 30;    ///< ΔE per unit height, when a height is given

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.classes, Field{.name = "classes",
                              .unit = "colours",
                              .min = 1,
                              .max = kMaxClasses,
                              .help = "number of colour classes (K): the dominant hues are a good guess",
                              .auto_help = "where one more class stops paying"});
    visit(self.height_weight, Field{.name = "height-weight",
                                    .unit = "ΔE per unit height",
                                    .min = 0,
                                    .max = 1000,
                                    .help = "weight of the height map among the colour coordinates"});
  }
};

/// How well palette, index and variation stand for the exemplar.
struct ColorError {
  double mean_delta_e = 0;  ///< Euclidean in CIELUV
  double p99_delta_e = 0;
};

struct Conversion {
  PrincipalVariation colors;
  ColorError error;
};

/// K that `convert` will use is in the result of `resolve`. Throws Error(bad_data) when the exemplar has fewer distinct
/// colours than `classes`.
ConvertOptions resolve(const ConvertOptions& options, ImageView<const V3f> exemplar);

/// `exemplar` is a tile in linear Rec.709; `height_01` is empty or of the same size.
Conversion convert(ImageView<const V3f> exemplar, ImageView<const float> height_01, const ConvertOptions& options = {},
                   const Progress& progress = {});

}  // namespace texbake
