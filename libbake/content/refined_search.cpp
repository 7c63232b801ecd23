#include "libbake/content/refined_search.h"

#include <algorithm>
#include <map>

#include "libbake/base/parallel.h"
#include "libbake/content/group_search.h"

namespace texbake {
namespace {

constexpr int kFinerSeparation = 4;

// Each block's most frequent value; blocks at the right and lower border may be cut short.
template <class T>
Image<T> reduce(ImageView<const T> image, int factor) {
  Image<T> reduced((image.width() + factor - 1) / factor, (image.height() + factor - 1) / factor);
  parallel_for(0, reduced.height(), [&](int y) {
    std::map<T, int> counts;
    for (int x = 0; x < reduced.width(); ++x) {
      counts.clear();
      for (int v = y * factor; v < std::min((y + 1) * factor, image.height()); ++v)
        for (int u = x * factor; u < std::min((x + 1) * factor, image.width()); ++u) ++counts[image(u, v)];
      const auto more = [](const auto& a, const auto& b) { return a.second < b.second; };
      reduced(x, y) = std::max_element(counts.begin(), counts.end(), more)->first;
    }
  });
  return reduced;
}

// The best of the candidates found at reduced size, and those that full-size candidates as far apart as asked for may
// grow from: the best alone leave too few of these.
Candidates promising(const Candidates& reduced, int factor, V2i reduced_size, const SearchRequest& request) {
  const auto count = std::min<size_t>(reduced.size(), kRefinedNeighborhoods);
  Candidates chosen(reduced.begin(), reduced.begin() + static_cast<ptrdiff_t>(count));
  const Candidates apart =
      take_separated(reduced, reduced_size, {request.count, (request.separation_px + factor - 1) / factor, {}});
  for (const Candidate& candidate : apart)
    if (std::find(chosen.begin(), chosen.end(), candidate) == chosen.end()) chosen.push_back(candidate);
  return chosen;
}

// How many of the candidates found at reduced size are far enough apart at full size.
int reachable_count(Candidates reduced, int factor, V2i size, const SearchRequest& request) {
  for (Candidate& candidate : reduced) candidate.translation *= factor;
  return static_cast<int>(take_separated(reduced, size, request).size());
}

// The groups of full-size translations that cover the neighborhoods of reduced ones, and the patches that want them.
std::vector<GroupTask> neighborhoods(const std::vector<Candidates>& reduced, int factor, V2i size) {
  std::map<std::pair<int, int>, std::vector<uint8_t>> wanted;
  for (size_t patch = 0; patch < reduced.size(); ++patch)
    for (const Candidate& candidate : reduced[patch])
      for (int y = (candidate.translation.y - 1) * factor + 1; y < (candidate.translation.y + 1) * factor; ++y)
        for (const int x : {(candidate.translation.x - 1) * factor + 1, (candidate.translation.x + 1) * factor - 1}) {
          const V2i t = wrap(V2i(x, y), size);
          auto& patches = wanted[{t.x / kGroupWidth, t.y / kGroupRows}];
          patches.resize(reduced.size(), 0);
          patches[patch] = 1;
        }
  std::vector<std::pair<V2i, const std::vector<uint8_t>*>> groups;
  for (const auto& [group, patches] : wanted)
    groups.emplace_back(V2i(group.first * kGroupWidth, group.second * kGroupRows), &patches);
  std::vector<GroupTask> tasks;
  for (const int g : scattered_batches(static_cast<int>(groups.size())))
    tasks.push_back({groups[static_cast<size_t>(g)].first, *groups[static_cast<size_t>(g)].second});
  return tasks;
}

}  // namespace

SearchResult search_contents_refined(ImageView<const uint8_t> classes, const ClassDistances& distances,
                                     ImageView<const uint32_t> patch_idx, int patch_count, const SearchRequest& request,
                                     const Progress& progress) {
  const PatchBorders borders = patch_borders(patch_idx, patch_count);
  int factor = 1;
  while (std::max(classes.width(), classes.height()) > kExactSide * factor) factor *= 2;
  if (factor == 1) return search_contents(classes, distances, borders, request, progress);

  // Search the reduced tile. A finer separation there lets the best region of the full search move between candidates.
  const Image<uint8_t> small_classes = reduce(classes, factor);
  const Image<uint32_t> small_patches = reduce(patch_idx, factor);
  const SearchRequest small_request{static_cast<int>(small_classes.size()),
                                    std::max(request.separation_px / (kFinerSeparation * factor), 1)};
  SearchResult small = search_contents(small_classes, distances, patch_borders(small_patches, patch_count),
                                       small_request, [&](double done) { report_progress(progress, 0.5 * done); });

  // Rank what lies around the best again, exactly.
  const V2i small_size(small_classes.width(), small_classes.height());
  for (Candidates& candidates : small.candidates) candidates = promising(candidates, factor, small_size, request);
  const V2i size(classes.width(), classes.height());
  SearchRequest reachable = request;
  for (const Candidates& candidates : small.candidates)
    reachable.count = std::min(reachable.count, reachable_count(candidates, factor, size, request));
  SearchResult result = GroupSearch(classes, distances, borders)
                            .run(neighborhoods(small.candidates, factor, size), reachable,
                                 [&](double done) { report_progress(progress, 0.5 + 0.5 * done); });
  result.error_count += small.error_count;
  result.all_error_count = 0;
  for (const size_t texels : borders.texel_counts) result.all_error_count += texels * classes.size();
  return result;
}

}  // namespace texbake
