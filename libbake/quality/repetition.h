// How much of a rendering repeats with the tile, near and from afar.
#pragma once

#include <optional>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

struct Repetition {
  double share = 0;              ///< G: share of the variance that repeats with the tile; 1 periodic, 0 ideal
  double amplitude_delta_e = 0;  ///< A = sqrt(max(G, 0) · V), in ΔE
};

/// Measures the m × m' tiles of `rendering_luv` (CIELUV; width and height whole multiples of `tile`, at least two tiles
/// in all) after a low-pass of `sigma_px` ≥ 0 on the torus of the rendering:
///   G = (V_M − V/n) / (V (1 − 1/n)), n = number of tiles, V the variance, V_M that of the mean over the tiles.
/// Nothing when the low-passed rendering is constant: the measure is not defined there. Throws Error(usage) on a size
/// that is not whole tiles.
std::optional<Repetition> repetition(ImageView<const V3f> rendering_luv, V2i tile, double sigma_px);

/// The share G near each texel of the tile: |mean over the tiles|² and the mean |·|², both less the tile's mean and
/// both smoothed by 1/32 of its shorter side, in the formula above; clamped to 0 … 1. Where the rendering hardly varies
/// it is 0. At reduced size for large tiles. `rendering_luv` as in `repetition`.
Image<float> repetition_map(ImageView<const V3f> rendering_luv, V2i tile);

}  // namespace texbake
