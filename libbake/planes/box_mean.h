// Means over squares of texels.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/reference/glsl.h"

namespace texbake {

/// The mean over side × side texels around each texel of a tile that repeats: from −(side / 2) on. Summed in double, in
/// a fixed order.
Image<glsl::vec4> box_means(const Image<V3f>& tile, int side);

}  // namespace texbake
