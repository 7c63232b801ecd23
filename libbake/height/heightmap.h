// A height map from a few clicks: heights given at some texels spread to all that look alike.
// Based on: Vanhoey et al. 2013, §7, height map creation tool, eq. 6 and 7.
#pragma once

#include <vector>

#include "libbake/base/options.h"
#include "libbake/base/progress.h"
#include "libbake/color/palette.h"

namespace texbake {

/// The user's word that the surface at `texel` has this height.
struct HeightClick {
  V2i texel{0, 0};
  float height_01 = 0;
};

struct HeightmapOptions {
  int max_representatives = 1024;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.max_representatives,
          Field{.name = "max-representatives",
                .unit = "clicks",
                .min = 3,
                .max = 100000,
                .help = "a class with more clicks, such as strokes of a brush, keeps those whose surroundings differ "
                        "most"});
  }
};

struct Heightmap {
  Image<float> height_01;
  std::vector<int> classes_without_click;  ///< their texels were compared with the clicks of all classes
  int clicks_used = 0;                     ///< after the reduction to representatives
};

/// Each texel's height is the mean of its three nearest clicks (all of them, where there are fewer) of the same colour
/// class, weighted by the inverse of the distance of eq. 7 between descriptors of eq. 6: gradients of the variation,
/// smoothed inside its class by σ = 1 … 6 px, at 3 × 3 texels; the least over turns of the click by −π/8, 0 and π/8.
/// A texel at distance 0 from a click takes its height. One click gives a constant height.
/// Throws Error(bad_data) without a click, for a click outside the tile, a height outside 0 … 1, or two heights on one
/// texel.
Heightmap heightmap(const PrincipalVariation& colors, const std::vector<HeightClick>& clicks,
                    const HeightmapOptions& options = {}, const Progress& progress = {});

}  // namespace texbake
