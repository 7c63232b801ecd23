#include "libbake/noise/sharp_border.h"

#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/noise/masks.h"

namespace texbake {

Image<uint8_t> border_band(const std::vector<Image<float>>& masks, double width_px) {
  const Image<uint8_t> label = strongest_mask(masks);
  const int width = label.width();
  const int height = label.height();
  const int reach = static_cast<int>(std::floor(width_px));
  std::vector<V2i> disc;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      if (dx * dx + dy * dy <= width_px * width_px) disc.emplace_back(dx, dy);
  Image<uint8_t> band(width, height);
  parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x)
      for (const V2i& d : disc)
        if (label(wrap(x + d.x, width), wrap(y + d.y, height)) != label(x, y)) {
          band(x, y) = 1;
          break;
        }
  });
  return band;
}

void keep_sharp_borders(ImageView<const V3f> exemplar, const Image<uint8_t>& band, Image<V3f>& structure,
                        std::vector<Image<float>>& masks) {
  Image<float> quiet(band.width(), band.height());
  for (size_t i = 0; i < band.size(); ++i) {
    if (band.data()[i] == 0) continue;
    structure.data()[i] = exemplar.data()[i];
    for (Image<float>& mask : masks) mask.data()[i] = 0.0f;
    quiet.data()[i] = 1.0f;
  }
  masks.push_back(std::move(quiet));
}

}  // namespace texbake
