// Keeps the borders between noises sharp: in a band along them the structure is the exemplar and there is no noise.
// Based on: Guingo et al. 2017, §6 and Fig. 16.
#pragma once

#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// 1 at the texels whose distance to a texel of another strongest mask is at most `width_px` (Euclidean, between texel
/// centers, on the torus), else 0.
Image<uint8_t> border_band(const std::vector<Image<float>>& masks, double width_px);

/// In the band `structure` becomes the exemplar, and the masks become 0. A last mask is added that is 1 in the band:
/// its noise is zero, so the masks still sum to 1 and whatever reads them stays as it is.
void keep_sharp_borders(ImageView<const V3f> exemplar, const Image<uint8_t>& band, Image<V3f>& structure,
                        std::vector<Image<float>>& masks);

}  // namespace texbake
