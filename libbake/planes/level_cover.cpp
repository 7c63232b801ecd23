#include "libbake/planes/level_cover.h"

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

LevelCover coarsened(const LevelCover& finer, V2i size) {
  LevelCover cover{size, {0}, {}};
  const V2i children(finer.size.x / size.x, finer.size.y / size.y);
  std::vector<std::vector<PatchTexel>> rows(static_cast<size_t>(cover.size.y));
  std::vector<std::vector<uint32_t>> counts(rows.size());
  parallel_for(0, cover.size.y, [&](int y) {
    auto& row = rows[static_cast<size_t>(y)];
    for (int x = 0; x < cover.size.x; ++x) {
      const size_t begin = row.size();
      for (int j = 0; j < children.y; ++j)
        for (int i = 0; i < children.x; ++i) unite(row, begin, finer.at(x * children.x + i, y * children.y + j));
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
