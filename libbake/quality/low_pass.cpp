#include "libbake/quality/low_pass.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"

namespace texbake {

int reduction_factor(V2i size, double sigma_px) {
  int factor = 1;
  while (size.x % (2 * factor) == 0 && size.y % (2 * factor) == 0 && sigma_px / (2 * factor) >= 2.0) factor *= 2;
  return factor;
}

Image<V3f> reduce(ImageView<const V3f> image, int factor) {
  Image<V3f> reduced(image.width() / factor, image.height() / factor);
  parallel_for(0, reduced.height(), [&](int y) {
    for (int x = 0; x < reduced.width(); ++x) {
      V3f sum(0);
      for (int dy = 0; dy < factor; ++dy)
        for (int dx = 0; dx < factor; ++dx) sum += image(x * factor + dx, y * factor + dy);
      reduced(x, y) = sum / static_cast<float>(factor * factor);
    }
  });
  return reduced;
}

Image<V3f> low_pass(ImageView<const V3f> image, double sigma_px, int factor) {
  if (factor == 1) return gaussian_blur(image, sigma_px, Wrap::repeat);
  // A block of f texels has the variance (f² − 1)/12.
  const double block_variance = (static_cast<double>(factor) * factor - 1.0) / 12.0;
  const double rest_px = std::sqrt(std::max(sigma_px * sigma_px - block_variance, 0.0));
  return gaussian_blur(reduce(image, factor), rest_px / factor, Wrap::repeat);
}

}  // namespace texbake
