// Takes out of a tile what gives its repetition away: shading, and features that stand out from all others.
// Based on: local mean and contrast normalization, as before texture matching (Heeger and Bergen 1995; Lowe 2004, §6).
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/options.h"
#include "libbake/base/torus.h"

namespace texbake {

struct FlattenOptions {
  float flatten_px = 0;
  float contrast = 0.5f;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.flatten_px,
          Field{.name = "flatten",
                .unit = "px",
                .min = 0,
                .max = 8192,
                .help = "scale (a Gaussian's σ) at which local mean and contrast of the color are evened out; this "
                        "removes shading and outliers; 0: off; an eighth of the tile's side is a good start"});
    visit(self.contrast,
          Field{.name = "flatten-contrast",
                .min = 0,
                .max = 1,
                .help = "share of the difference between local contrast and the tile's that --flatten evens out"});
  }
};

/// `tile` in linear Rec.709, on the torus: in CIELUV, less its Gaussian mean at σ = flatten_px, times the local gain
/// (tile's deviation from that mean / local deviation)^contrast, limited to 0.5 … 2, plus the tile's mean. Negative
/// light becomes 0. A scale of 0 gives the tile itself.
Image<V3f> flatten(ImageView<const V3f> tile, const FlattenOptions& options);

}  // namespace texbake
