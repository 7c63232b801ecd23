// The picture around each texel without its detail: what soft borders blend plainly.
#pragma once

#include "libbake/base/image.h"
#include "libbake/reference/glsl.h"

namespace texbake {

/// Gaussian mean of a plane on the torus, of standard deviation 2 · `soft_border_px`: as wide as the blend itself.
Image<glsl::vec4> local_mean(ImageView<const glsl::vec4> texels, int soft_border_px);

}  // namespace texbake
