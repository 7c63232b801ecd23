// Means over squares of texels.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/eval/glsl.h"

namespace texbake {

/// The mean over side × side texels around each texel of a tile that repeats: from −(side / 2) on. Summed in double, in
/// a fixed order.
Image<glsl::vec4> box_means(const Image<V3f>& tile, int side);

/// Means of 2 × 2 neighbours; an odd last row or column is left out.
Image<Imath::V3d> halved(const Image<Imath::V3d>& finer);

}  // namespace texbake
