// The classes by whose mean colors contents are compared: dominant color and saliency together.
// Based on: Vanhoey et al. 2013, §5.2: the dominant colors' classes, refined by two classes of saliency.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/color/palette.h"

namespace texbake {

struct ContentClasses {
  Image<uint8_t> idx;            ///< class j of each texel, 0 … count−1, all used
  std::vector<V3f> mean_luv;     ///< C_j, CIELUV
  float saliency_threshold = 1;  ///< texels above it are salient
  double salient_share = 0;      ///< of the texels

  int count() const { return static_cast<int>(mean_luv.size()); }
};

/// At most 2K classes, those of dominant color 0 first, the salient ones after the others. `base` is the picture
/// behind `colors`, linear Rec.709.
ContentClasses content_classes(const PrincipalVariation& colors, ImageView<const V3f> base);

}  // namespace texbake
