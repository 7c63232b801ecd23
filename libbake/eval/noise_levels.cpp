#include "libbake/eval/noise_levels.h"

#include <vector>

#include "libbake/base/half.h"
#include "libbake/eval/box_mean.h"

namespace texbake {

using Imath::V3d;

void fill_noise_levels(Image<glsl::vec4>& noise_tiles, int size, int first_row) {
  std::vector<Image<V3d>> levels;
  levels.emplace_back(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const glsl::vec4& v = noise_tiles(x, first_row + y);
      levels[0](x, y) = V3d(double{v.x}, double{v.y}, double{v.z});
    }
  while (levels.back().width() > 1) levels.push_back(halved(levels.back()));

  const V3d mean = levels.back()(0, 0);
  int row = first_row;
  for (size_t level = 1; level < levels.size(); ++level) {
    const Image<V3d>& blocks = levels[level];
    for (int y = 0; y < blocks.height(); ++y)
      for (int x = 0; x < blocks.width(); ++x) {
        const V3f rest = half_exact(V3f(blocks(x, y) - mean));
        noise_tiles(size + x, row + y) = {rest.x, rest.y, rest.z, 0};
      }
    row += blocks.height();
  }
}

}  // namespace texbake
