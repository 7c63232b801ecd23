// The mean of an image.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Summed in double, in row order. `image` is not empty.
V3f mean_of(ImageView<const V3f> image);

}  // namespace texbake
