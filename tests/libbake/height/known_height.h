// Clicks on a surface whose heights are known, to measure how well they are recovered.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"
#include "libbake/height/heightmap.h"

namespace texbake::twin {

inline HeightClick click_on(const Image<float>& truth, size_t texel) {
  const auto width = static_cast<size_t>(truth.width());
  return {{static_cast<int>(texel % width), static_cast<int>(texel / width)}, truth.data()[texel]};
}

/// Clicks anywhere.
inline std::vector<HeightClick> random_clicks(const Image<float>& truth, int count, uint64_t seed) {
  Random random(seed);
  std::vector<HeightClick> clicks;
  for (int i = 0; i < count; ++i) clicks.push_back(click_on(truth, random.below(static_cast<uint32_t>(truth.size()))));
  return clicks;
}

/// Clicks as a person chooses them: from the deepest places to the highest in even steps of rank, each in the middle of
/// what it lies on. Of 64 texels within 3 % of the rank, drawn by `seed`, the one where the height changes least.
inline std::vector<HeightClick> chosen_clicks(const Image<float>& truth, int count, uint64_t seed) {
  std::vector<size_t> by_height(truth.size());
  std::iota(by_height.begin(), by_height.end(), size_t{0});
  std::ranges::stable_sort(by_height, {}, [&](size_t texel) { return truth.data()[texel]; });
  const Image<float> smooth = gaussian_blur(truth, 1.0, Wrap::repeat);
  const auto slope = [&](size_t texel) {
    const V2i p = click_on(truth, texel).texel;
    const int w = truth.width(), h = truth.height();
    const float dx = smooth(wrap(p.x + 1, w), p.y) - smooth(wrap(p.x - 1, w), p.y);
    const float dy = smooth(p.x, wrap(p.y + 1, h)) - smooth(p.x, wrap(p.y - 1, h));
    return dx * dx + dy * dy;
  };
  Random random(seed);
  std::vector<HeightClick> clicks;
  for (int i = 0; i < count; ++i) {
    const double rank = (i + 0.5) / count;
    const auto first = static_cast<size_t>(std::max(0.0, rank - 0.03) * static_cast<double>(truth.size()));
    const auto span = static_cast<uint32_t>(0.06 * static_cast<double>(truth.size()));
    const auto draw = [&] { return by_height[std::min(first + random.below(span), truth.size() - 1)]; };
    size_t best = draw();
    for (int other = 1; other < 64; ++other) {
      const size_t drawn = draw();
      if (slope(drawn) < slope(best)) best = drawn;
    }
    clicks.push_back(click_on(truth, best));
  }
  return clicks;
}

}  // namespace texbake::twin
