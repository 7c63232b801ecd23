#include "libbake/content/pair_impact.h"

#include <algorithm>
#include <map>

#include "libbake/base/parallel.h"
#include "libbake/content/patch_border.h"

namespace texbake {
namespace {

// The common border of two patches.
struct PairBorder {
  uint32_t a = 0;
  uint32_t b = 0;
  std::vector<V2i> seeds;  // texels with a 4-neighbour in the other patch
  std::vector<V2i> band;   // texels of a and b within the dilation of these
};

std::vector<PairBorder> find_borders(ImageView<const uint32_t> idx) {
  const V2i size(idx.width(), idx.height());
  std::map<std::pair<uint32_t, uint32_t>, std::vector<V2i>> seeds;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int i = 0; i < 4; ++i) {
        const V2i q = wrap(V2i(x + kNeighbourX[i], y + kNeighbourY[i]), size);
        const uint32_t a = idx(x, y);
        const uint32_t b = idx(q.x, q.y);
        if (a != b) seeds[std::minmax(a, b)].emplace_back(x, y);
      }
  std::vector<PairBorder> borders;
  for (auto& [pair, texels] : seeds) borders.push_back({pair.first, pair.second, std::move(texels), {}});
  return borders;
}

void dilate(PairBorder& border, ImageView<const uint32_t> idx) {
  const V2i size(idx.width(), idx.height());
  for (const V2i& seed : border.seeds)
    for (int dy = -kBorderDilation; dy <= kBorderDilation; ++dy)
      for (int dx = -kBorderDilation; dx <= kBorderDilation; ++dx) {
        const V2i p = wrap(seed + V2i(dx, dy), size);
        if (idx(p.x, p.y) == border.a || idx(p.x, p.y) == border.b) border.band.push_back(p);
      }
  const auto by_row = [](const V2i& p, const V2i& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; };
  std::sort(border.band.begin(), border.band.end(), by_row);
  border.band.erase(std::unique(border.band.begin(), border.band.end()), border.band.end());
}

double impact_of(const PairBorder& border, V2i t_a, V2i t_b, ImageView<const uint8_t> classes,
                 const ClassDistances& distances) {
  const V2i size(classes.width(), classes.height());
  const auto delta = [&](V2i p) -> uint64_t {
    const V2i from_a = wrap(p + t_a, size);
    const V2i from_b = wrap(p + t_b, size);
    return distances.at(classes(from_a.x, from_a.y), classes(from_b.x, from_b.y));
  };
  uint64_t sum = 0;
  for (const V2i& p : border.band) {
    const uint64_t own = delta(p);
    if (own == 0) continue;
    uint64_t around = 0;
    for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy)
      for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) around += delta(p + V2i(dx, dy));
    sum += own * around;
  }
  return distances.impact(sum, border.band.size());
}

}  // namespace

PairImpact pair_impact(ImageView<const uint8_t> classes, const ClassDistances& distances,
                       ImageView<const uint32_t> patch_idx, const std::vector<std::vector<V2i>>& translations) {
  std::vector<PairBorder> borders = find_borders(patch_idx);
  std::vector<std::vector<double>> impacts(borders.size());
  parallel_for(0, static_cast<int>(borders.size()), [&](int i) {
    PairBorder& border = borders[static_cast<size_t>(i)];
    dilate(border, patch_idx);
    for (const V2i& t_a : translations[border.a])
      for (const V2i& t_b : translations[border.b])
        impacts[static_cast<size_t>(i)].push_back(impact_of(border, t_a, t_b, classes, distances));
  });
  PairImpact result;
  size_t count = 0;
  for (const auto& of_border : impacts)
    for (const double impact : of_border) {
      result.mean += impact;
      result.worst = std::max(result.worst, impact);
      ++count;
    }
  if (count > 0) result.mean /= static_cast<double>(count);
  return result;
}

}  // namespace texbake
