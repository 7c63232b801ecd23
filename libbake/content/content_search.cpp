#include "libbake/content/content_search.h"

#include <algorithm>
#include <numeric>

#include "libbake/content/group_search.h"

namespace texbake {
namespace {

// Whether a translation of the group at `first` may be used.
bool any_allowed(V2i first, ImageView<const uint8_t> allowed) {
  if (allowed.empty()) return true;
  for (int y = first.y; y < std::min(first.y + kGroupRows, allowed.height()); ++y)
    for (int x = first.x; x < std::min(first.x + kGroupWidth, allowed.width()); ++x)
      if (allowed(x, y)) return true;
  return false;
}

}  // namespace

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
