#include "libbake/content/patch_border.h"

#include <algorithm>
#include <map>

namespace texbake {
namespace {

bool is_border(ImageView<const uint32_t> patch_idx, V2i p) {
  const V2i size(patch_idx.width(), patch_idx.height());
  for (int n = 0; n < 4; ++n) {
    const V2i q = wrap(p + V2i(kNeighborX[n], kNeighborY[n]), size);
    if (patch_idx(q.x, q.y) != patch_idx(p.x, p.y)) return true;
  }
  return false;
}

// Names sets of patches by indices, and remembers what a set becomes when a patch joins it.
class SetNames {
 public:
  uint32_t with(uint32_t set, uint32_t patch) {
    const auto [place, is_new] = joined_.try_emplace({set, patch}, 0);
    if (is_new) {
      std::vector<uint32_t> members = sets[set];
      const auto at = std::lower_bound(members.begin(), members.end(), patch);
      if (at == members.end() || *at != patch) members.insert(at, patch);
      place->second = name(members);
    }
    return place->second;
  }

  std::vector<std::vector<uint32_t>> sets = {{}};

 private:
  uint32_t name(const std::vector<uint32_t>& members) {
    const auto [place, is_new] = names_.try_emplace(members, static_cast<uint32_t>(sets.size()));
    if (is_new) sets.push_back(members);
    return place->second;
  }

  std::map<std::vector<uint32_t>, uint32_t> names_ = {{{}, 0}};
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> joined_;
};

}  // namespace

PatchBorders patch_borders(ImageView<const uint32_t> patch_idx, int patch_count) {
  const V2i size(patch_idx.width(), patch_idx.height());
  PatchBorders borders;
  borders.patch_count = patch_count;
  borders.set_idx = Image<uint32_t>(size.x, size.y);

  // Every texel of ∂P adds P to the sets of the texels around it.
  SetNames names;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      if (!is_border(patch_idx, {x, y})) continue;
      for (int dy = -kBorderDilation; dy <= kBorderDilation; ++dy)
        for (int dx = -kBorderDilation; dx <= kBorderDilation; ++dx) {
          const V2i q = wrap(V2i(x + dx, y + dy), size);
          borders.set_idx(q.x, q.y) = names.with(borders.set_idx(q.x, q.y), patch_idx(x, y));
        }
    }
  borders.sets = std::move(names.sets);

  borders.texel_counts.assign(static_cast<size_t>(patch_count), 0);
  for (const uint32_t set : borders.set_idx)
    for (const uint32_t patch : borders.sets[set]) ++borders.texel_counts[patch];
  return borders;
}

}  // namespace texbake
