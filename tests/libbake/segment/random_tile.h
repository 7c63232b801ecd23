// Small random tiles whose colors are whole numbers, so that sums do not depend on their order.
#pragma once

#include <algorithm>

#include "libbake/base/random.h"
#include "libbake/color/luv.h"
#include "libbake/color/palette.h"

namespace texbake {

/// Blotches of `classes` classes, a few texels wide, each with its own variation and some grain.
inline PrincipalVariation random_tile(int width, int height, int classes, uint32_t seed) {
  Random random(seed);
  PrincipalVariation colors;
  for (int k = 0; k < classes; ++k) {
    const float step = static_cast<float>(k);
    colors.palette.classes.push_back({V3f(20 + 40 * step, 8 * step, -8 * step), V3f(1, 0, 0)});
  }
  colors.index = Image<uint8_t>(width, height);
  colors.variation = Image<float>(width, height);
  struct Blotch {
    V2i center;
    uint8_t index;
    float v;
  };
  std::vector<Blotch> blotches;
  for (int i = 0; i < std::clamp(width * height / 20, 2, 300); ++i)
    blotches.push_back({V2i(static_cast<int>(random.below(static_cast<uint32_t>(width))),
                            static_cast<int>(random.below(static_cast<uint32_t>(height)))),
                        static_cast<uint8_t>(random.below(static_cast<uint32_t>(classes))),
                        static_cast<float>(random.below(16)) - 8});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Blotch* nearest = nullptr;
      int least = 0;
      for (const Blotch& b : blotches) {
        const V2i d = shortest(V2i(x - b.center.x, y - b.center.y), V2i(width, height));
        const int distance = d.x * d.x + d.y * d.y;
        if (nearest && distance >= least) continue;
        nearest = &b;
        least = distance;
      }
      colors.index(x, y) =
          random.below(12) == 0 ? static_cast<uint8_t>(random.below(static_cast<uint32_t>(classes))) : nearest->index;
      colors.variation(x, y) = nearest->v + static_cast<float>(random.below(3)) - 1;
    }
  return colors;
}

inline Image<V3f> luv_of(const PrincipalVariation& colors) {
  Image<V3f> luv(colors.index.width(), colors.index.height());
  for (size_t at = 0; at < luv.size(); ++at) {
    const ColorClass& c = colors.palette.classes[colors.index.data()[at]];
    luv.data()[at] = c.dominant + c.variation * colors.variation.data()[at];
  }
  return luv;
}

}  // namespace texbake
