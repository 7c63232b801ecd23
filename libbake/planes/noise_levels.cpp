#include "libbake/planes/noise_levels.h"

#include <utility>

#include "libbake/base/half.h"

namespace texbake {

using Imath::V3d;

Image<V3d> halved_noise(const Image<V3d>& finer, int row_step) {
  Image<V3d> coarser =
      finer.height() > 1 ? Image<V3d>(finer.width(), finer.height() / 2) : Image<V3d>(finer.width() / 2, 1);
  const size_t last = finer.size() - 1;
  const V3d* of = finer.data();
  for (size_t i = 0; i < coarser.size(); ++i) {
    const size_t below = 2 * i + static_cast<size_t>(row_step);
    coarser.data()[i] = (of[2 * i] + of[2 * i + 1] + of[below & last] + of[(below + 1) & last]) * 0.25;
  }
  return coarser;
}

void fill_noise_levels(Image<glsl::vec4>& noise_tiles, const NoiseLevels& of, V2i first,
                       const std::function<V3d(const V3d&)>& value) {
  const V2i size = of.size;
  Image<V3d> blocks(size.x, size.y);
  V3d mean(0);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glsl::vec4& v = noise_tiles(x, first.y + y);
      blocks(x, y) = value(V3d(double{v.x}, double{v.y}, double{v.z}));
      mean += blocks(x, y);
    }
  mean = of.keeps_mean ? V3d(0) : mean / static_cast<double>(blocks.size());

  int row = first.y;
  while (blocks.height() > 1) {
    blocks = halved_noise(blocks, of.row_step);
    for (int y = 0; y < blocks.height(); ++y)
      for (int x = 0; x < size.x; ++x) {
        const V3f rest = half_exact(V3f(blocks(x, y) - mean));
        noise_tiles(first.x + x, row + y) = {rest.x, rest.y, rest.z, 0};
      }
    row += blocks.height();
  }
}

}  // namespace texbake
