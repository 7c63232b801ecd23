#include "libbake/content/pair_impact.h"

#include <algorithm>
#include <array>
#include <map>

#include "libbake/base/parallel.h"
#include "libbake/content/patch_border.h"
#include "libbake/content/shown_source.h"

namespace texbake {
namespace {

// The common border of two patches.
struct PairBorder {
  uint32_t a = 0;
  uint32_t b = 0;
  std::vector<V2i> seeds;  // texels with a 4-neighbor in the other patch
  std::vector<V2i> band;   // texels of a and b within the dilation of these
};

std::vector<PairBorder> find_borders(ImageView<const uint32_t> idx) {
  const V2i size(idx.width(), idx.height());
  std::map<std::pair<uint32_t, uint32_t>, std::vector<V2i>> seeds;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int i = 0; i < 4; ++i) {
        const V2i q = wrap(V2i(x + kNeighborX[i], y + kNeighborY[i]), size);
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

// The texels within the mask of a band.
struct MaskedTexels {
  std::vector<V2i> texels;
  std::vector<std::array<uint32_t, kMaskSide * kMaskSide>> around;  // of each texel of the band, its own in the middle
};

MaskedTexels masked_texels(const std::vector<V2i>& band, V2i size) {
  MaskedTexels masked;
  Image<uint32_t> number(size.x, size.y, UINT32_MAX);
  for (const V2i& p : band) {
    auto& around = masked.around.emplace_back();
    auto* out = around.data();
    for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy)
      for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) {
        const V2i q = wrap(p + V2i(dx, dy), size);
        uint32_t& at = number(q.x, q.y);
        if (at == UINT32_MAX) {
          at = static_cast<uint32_t>(masked.texels.size());
          masked.texels.push_back(q);
        }
        *out++ = at;
      }
  }
  return masked;
}

// The classes that the contents of a patch show at `texels`.
std::vector<std::vector<uint8_t>> shown_classes(const ContentTable& table, const Partition& patches, uint32_t patch,
                                                const std::vector<V2i>& texels, ImageView<const uint8_t> classes) {
  std::vector<std::vector<uint8_t>> shown;
  for (const Content& content : table.of(static_cast<int>(patch))) {
    shown.emplace_back();
    for (const V2i& p : texels) {
      const V2i source = shown_source(patches, patch, p, content);
      shown.back().push_back(classes(source.x, source.y));
    }
  }
  return shown;
}

double impact_of(const MaskedTexels& masked, const std::vector<uint8_t>& a, const std::vector<uint8_t>& b,
                 const ClassDistances& distances) {
  std::vector<uint32_t> delta;
  for (size_t i = 0; i < a.size(); ++i) delta.push_back(distances.at(a[i], b[i]));
  uint64_t sum = 0;
  for (const auto& around : masked.around) {
    const uint64_t own = delta[around[around.size() / 2]];
    if (own == 0) continue;
    uint64_t box = 0;
    for (const uint32_t texel : around) box += delta[texel];
    sum += own * box;
  }
  return distances.impact(sum, masked.around.size());
}

}  // namespace

PairImpact pair_impact(ImageView<const uint8_t> classes, const ClassDistances& distances, const Partition& patches,
                       const ContentTable& table) {
  std::vector<PairBorder> borders = find_borders(patches.idx);
  std::vector<std::vector<double>> impacts(borders.size());
  parallel_for(0, static_cast<int>(borders.size()), [&](int i) {
    PairBorder& border = borders[static_cast<size_t>(i)];
    dilate(border, patches.idx);
    const MaskedTexels masked = masked_texels(border.band, patches.size());
    const auto shown_a = shown_classes(table, patches, border.a, masked.texels, classes);
    const auto shown_b = shown_classes(table, patches, border.b, masked.texels, classes);
    for (const auto& a : shown_a)
      for (const auto& b : shown_b) impacts[static_cast<size_t>(i)].push_back(impact_of(masked, a, b, distances));
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
