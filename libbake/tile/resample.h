// Another number of texels for the same picture.
#pragma once

#include "libbake/base/gaussian.h"
#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// What lies beyond the borders, for each axis.
struct Borders {
  Wrap x = Wrap::repeat;
  Wrap y = Wrap::repeat;
};

/// `image` with `width` × `height` texels, both ≥ 1, by Lanczos-3, widened where texels get fewer. The picture keeps
/// its borders: texel centers map by (i + 0.5) · old / new. Results stay between the least and the greatest value of
/// each channel. The same size gives the same values.
Image<float> resample(ImageView<const float> image, int width, int height, Borders borders);
Image<V3f> resample(ImageView<const V3f> image, int width, int height, Borders borders);

}  // namespace texbake
