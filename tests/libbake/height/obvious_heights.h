// The obvious loop that heightmap replaces: every click is compared with every texel, and all are sorted.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "libbake/color/luv.h"
#include "libbake/height/appearance.h"
#include "libbake/height/heightmap.h"

namespace texbake::twin {

/// By appearance, from the 8 nearest clicks by inverse squared distance, without smoothing.
inline Image<float> obvious_heights(ImageView<const V3f> base, const std::vector<HeightClick>& clicks) {
  const AppearancePyramid pyramid(luv_from_linear(base));
  Image<float> heights(base.width(), base.height());
  for (int y = 0; y < base.height(); ++y)
    for (int x = 0; x < base.width(); ++x) {
      const Appearance here = pyramid.at({x, y});
      std::vector<std::pair<double, float>> near;  // distance, height
      for (const HeightClick& click : clicks)
        near.emplace_back(appearance_distance(here.data(), pyramid.at(click.texel).data()), click.height_01);
      std::ranges::stable_sort(near, {}, &std::pair<double, float>::first);
      near.resize(std::min<size_t>(near.size(), 8));
      double sum = 0, weights = 0;
      for (const auto& [distance, height] : near) {
        if (near[0].first == 0) break;
        sum += height / (distance * distance);
        weights += 1 / (distance * distance);
      }
      heights(x, y) = near[0].first == 0 ? near[0].second : static_cast<float>(sum / weights);
    }
  return heights;
}

}  // namespace texbake::twin
