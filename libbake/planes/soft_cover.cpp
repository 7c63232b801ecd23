#include "libbake/planes/soft_cover.h"

#include <algorithm>
#include <cstdlib>

#include "libbake/base/parallel.h"

namespace texbake {
namespace {

using glsl::PatchTexel;

/// What the texels around one texel say.
struct Count {
  PatchTexel owned;
  int weight;
};

/// The texel at `p`, which may lie beyond the tile, as texels of the tile see it: an owner beyond is further away.
PatchTexel owned_at(ImageView<const PatchTexel> plane, V2i p) {
  const V2i size(plane.width(), plane.height());
  const V2i at = wrap(p, size);
  const PatchTexel owned = plane(at.x, at.y);
  const V2i beyond((p.x - at.x) / size.x, (p.y - at.y) / size.y);
  return {owned.patch_idx, static_cast<uint16_t>(owned.owner + beyond.x + 4 * beyond.y)};
}

void add(std::vector<Count>& counts, const PatchTexel& owned, int weight) {
  for (Count& count : counts)
    if (count.owned == owned) {
      count.weight += weight;
      return;
    }
  counts.push_back({owned, weight});
}

/// Whether nothing but a texel's own patch lies within `width` − 1 texels of it: of most texels, and soon known. Not
/// told near the borders of the tile, where owners differ.
Image<uint8_t> is_inside(ImageView<const PatchTexel> plane, int width) {
  const int reach = width - 1;
  Image<uint8_t> along_row(plane.width(), plane.height(), 0);
  parallel_for(0, plane.height(), [&](int y) {
    for (int x = reach; x < plane.width() - reach; ++x) {
      bool same = true;
      for (int d = -reach; d <= reach; ++d) same &= plane(x + d, y) == plane(x, y);
      along_row(x, y) = same;
    }
  });
  Image<uint8_t> inside(plane.width(), plane.height(), 0);
  parallel_for(reach, std::max(reach, plane.height() - reach), [&](int y) {
    for (int x = 0; x < plane.width(); ++x) {
      bool same = true;
      for (int d = -reach; d <= reach; ++d) same &= along_row(x, y + d) && plane(x, y + d) == plane(x, y);
      inside(x, y) = same;
    }
  });
  return inside;
}

/// The texel's own patch first.
std::vector<Count> counts_at(ImageView<const PatchTexel> plane, V2i p, int width) {
  std::vector<Count> counts = {{plane(p.x, p.y), 0}};
  for (int dy = 1 - width; dy < width; ++dy)
    for (int dx = 1 - width; dx < width; ++dx)
      add(counts, owned_at(plane, p + V2i(dx, dy)), (width - std::abs(dx)) * (width - std::abs(dy)));
  return counts;
}

}  // namespace

SoftCover soft_cover(ImageView<const PatchTexel> patch_plane, int width_px) {
  const int height = patch_plane.height();
  std::vector<std::vector<Count>> rows(static_cast<size_t>(height));
  std::vector<std::vector<uint32_t>> sizes(rows.size());
  const int whole = width_px * width_px * width_px * width_px;
  const Image<uint8_t> inside = is_inside(patch_plane, width_px);
  parallel_for(0, height, [&](int y) {
    for (int x = 0; x < patch_plane.width(); ++x) {
      if (inside(x, y)) {
        sizes[static_cast<size_t>(y)].push_back(1);
        rows[static_cast<size_t>(y)].push_back({patch_plane(x, y), whole});
        continue;
      }
      const std::vector<Count> counts = counts_at(patch_plane, {x, y}, width_px);
      sizes[static_cast<size_t>(y)].push_back(static_cast<uint32_t>(counts.size()));
      rows[static_cast<size_t>(y)].insert(rows[static_cast<size_t>(y)].end(), counts.begin(), counts.end());
    }
  });
  SoftCover soft{{{patch_plane.width(), height}, {0}, {}}, {}};
  const auto total = static_cast<float>(whole);
  for (size_t y = 0; y < rows.size(); ++y) {
    for (const uint32_t size : sizes[y]) soft.cover.first.push_back(soft.cover.first.back() + size);
    for (const Count& count : rows[y]) {
      soft.cover.entries.push_back(count.owned);
      soft.weights.push_back(static_cast<float>(count.weight) / total);
    }
  }
  return soft;
}

}  // namespace texbake
