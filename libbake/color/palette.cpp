#include "libbake/color/palette.h"

#include <algorithm>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"

namespace texbake {

Image<V3f> decode(const PrincipalVariation& colors) {
  Image<V3f> linear(colors.index.width(), colors.index.height());
  parallel_for(0, linear.height(), [&](int y) {
    for (int x = 0; x < linear.width(); ++x) {
      const ColorClass& c = colors.palette.classes[colors.index(x, y)];
      const V3f color = linear_from_luv(c.dominant + c.variation * colors.variation(x, y));
      linear(x, y) = {std::max(color.x, 0.0f), std::max(color.y, 0.0f), std::max(color.z, 0.0f)};
    }
  });
  return linear;
}

Image<V3f> decode_dominant(const PrincipalVariation& colors) {
  std::vector<V3f> dominants;
  for (const ColorClass& c : colors.palette.classes) dominants.push_back(linear_from_luv(c.dominant));
  Image<V3f> linear(colors.index.width(), colors.index.height());
  parallel_for(0, linear.height(), [&](int y) {
    for (int x = 0; x < linear.width(); ++x) linear(x, y) = dominants[colors.index(x, y)];
  });
  return linear;
}

}  // namespace texbake
