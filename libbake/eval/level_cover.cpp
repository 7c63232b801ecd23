#include "libbake/eval/level_cover.h"

#include <algorithm>
#include <numeric>

#include "libbake/base/parallel.h"

namespace texbake {
namespace {

using glsl::PatchTexel;

/// Appends what `more` has and `entries` from `begin` on has not.
void unite(std::vector<PatchTexel>& entries, size_t begin, std::span<const PatchTexel> more) {
  for (const PatchTexel& owned : more) {
    const auto from = entries.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::find(from, entries.end(), owned) == entries.end()) entries.push_back(owned);
  }
}

}  // namespace

LevelCover texel_cover(ImageView<const PatchTexel> patch_plane) {
  LevelCover cover{{patch_plane.width(), patch_plane.height()}, {}, {patch_plane.begin(), patch_plane.end()}};
  cover.first.resize(patch_plane.size() + 1);
  std::iota(cover.first.begin(), cover.first.end(), 0u);
  return cover;
}

LevelCover halved(const LevelCover& finer) {
  LevelCover cover{{finer.size.x / 2, finer.size.y / 2}, {0}, {}};
  std::vector<std::vector<PatchTexel>> rows(static_cast<size_t>(cover.size.y));
  std::vector<std::vector<uint32_t>> counts(rows.size());
  parallel_for(0, cover.size.y, [&](int y) {
    auto& row = rows[static_cast<size_t>(y)];
    for (int x = 0; x < cover.size.x; ++x) {
      const size_t begin = row.size();
      for (const V2i& child : {V2i(0, 0), V2i(1, 0), V2i(0, 1), V2i(1, 1)})
        unite(row, begin, finer.at(2 * x + child.x, 2 * y + child.y));
      counts[static_cast<size_t>(y)].push_back(static_cast<uint32_t>(row.size() - begin));
    }
  });
  for (size_t y = 0; y < rows.size(); ++y) {
    for (const uint32_t count : counts[y]) cover.first.push_back(cover.first.back() + count);
    cover.entries.insert(cover.entries.end(), rows[y].begin(), rows[y].end());
  }
  return cover;
}

}  // namespace texbake
