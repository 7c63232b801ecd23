#include "libbake/base/mean.h"

namespace texbake {

V3f mean_of(ImageView<const V3f> image) {
  double sum[3] = {};
  for (const V3f& c : image)
    for (int i = 0; i < 3; ++i) sum[i] += static_cast<double>(c[i]);
  const auto n = static_cast<double>(image.size());
  return {static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n), static_cast<float>(sum[2] / n)};
}

}  // namespace texbake
