#include "libbake/content/content_search.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "libbake/content/group_search.h"

namespace texbake {
namespace {

bool by_error(const Candidate& a, const Candidate& b) {
  if (a.error_sum != b.error_sum) return a.error_sum < b.error_sum;
  if (a.translation.y != b.translation.y) return a.translation.y < b.translation.y;
  if (a.translation.x != b.translation.x) return a.translation.x < b.translation.x;
  return a.turn < b.turn;
}

// The translations that are not far enough from some others.
class NearTranslations {
 public:
  NearTranslations(V2i size, int separation_px) : is_near_(size.x, size.y), separation_px_(separation_px) {}

  void add(V2i t) {
    const V2i size(is_near_.width(), is_near_.height());
    const V2i reach(std::min(separation_px_ - 1, size.x / 2), std::min(separation_px_ - 1, size.y / 2));
    for (int dy = -reach.y; dy <= reach.y; ++dy) {
      uint8_t* row = is_near_.row(wrap(t.y + dy, size.y));
      for (int dx = -reach.x; dx <= reach.x; ++dx) row[wrap(t.x + dx, size.x)] = 1;
    }
  }
  bool contains(V2i t) const { return is_near_(t.x, t.y) != 0; }

 private:
  Image<uint8_t> is_near_;
  int separation_px_;
};

// Whether a translation of the group at `first` may be used.
bool any_allowed(V2i first, ImageView<const uint8_t> allowed) {
  if (allowed.empty()) return true;
  for (int y = first.y; y < std::min(first.y + kGroupRows, allowed.height()); ++y)
    for (int x = first.x; x < std::min(first.x + kGroupWidth, allowed.width()); ++x)
      if (allowed(x, y)) return true;
  return false;
}

}  // namespace

bool far_enough(V2i a, V2i b, V2i size, int separation_px) {
  const V2i d = shortest(a - b, size);
  return std::max(std::abs(d.x), std::abs(d.y)) >= separation_px;
}

Candidates take_separated(Candidates found, V2i size, const SearchRequest& request) {
  std::sort(found.begin(), found.end(), by_error);
  NearTranslations near(size, request.separation_px);
  near.add({0, 0});
  Candidates taken;
  for (const Candidate& candidate : found) {
    if (taken.size() == static_cast<size_t>(request.count)) break;
    if (near.contains(candidate.translation)) continue;
    near.add(candidate.translation);
    taken.push_back(candidate);
  }
  return taken;
}

SearchResult search_contents(ImageView<const uint8_t> classes, const ClassDistances& distances,
                             const PatchBorders& borders, const SearchRequest& request, const Progress& progress) {
  // All groups of translations with an allowed one, column by column: those of a batch lie below each other.
  const int groups_x = (classes.width() + kGroupWidth - 1) / kGroupWidth;
  const int groups_y = (classes.height() + kGroupRows - 1) / kGroupRows;
  std::vector<GroupTask> tasks;
  for (const int g : scattered_batches(groups_x * groups_y)) {
    const V2i first(g / groups_y * kGroupWidth, g % groups_y * kGroupRows);
    if (any_allowed(first, request.allowed)) tasks.push_back({first, {}});
  }

  SearchResult result = GroupSearch(classes, distances, borders).run(tasks, request, progress);
  const size_t texels = std::accumulate(borders.texel_counts.begin(), borders.texel_counts.end(), size_t{0});
  result.all_error_count = texels * classes.size();
  return result;
}

}  // namespace texbake
