#include "libbake/content/turned_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "libbake/base/parallel.h"
#include "libbake/content/take_apart.h"
#include "libbake/content/turned_bound.h"
#include "libbake/content/turned_impact.h"

namespace texbake {
namespace {

constexpr size_t kBestBounds = 1500;  // of each patch, whose impact is computed
constexpr int kTasks = 32;            // in which impacts are computed

struct PatchTexels {
  std::vector<V2i> offsets;  // of dil(∂P) from the center
  std::vector<BorderTexel> border;
};

// A patch is under half a tile wide: the shortest offset on the torus is the one in the plane.
std::vector<PatchTexels> texels_of_patches(ImageView<const uint8_t> classes, const PatchBorders& borders,
                                           const Partition& patches) {
  std::vector<PatchTexels> texels(static_cast<size_t>(patches.count()));
  for (int y = 0; y < classes.height(); ++y)
    for (int x = 0; x < classes.width(); ++x)
      for (const uint32_t patch : borders.sets[borders.set_idx(x, y)]) {
        const V2i offset = shortest(V2i(x, y) - patches.centers[patch], patches.size());
        texels[patch].offsets.push_back(offset);
        texels[patch].border.push_back({offset, classes(x, y)});
      }
  return texels;
}

// The search for one patch.
class PatchSearch {
 public:
  PatchSearch(ImageView<const uint8_t> classes, const ClassDistances& distances, const TurnedBound& bound,
              const PatchTexels& texels, V2i center, const Turns& turns, const SearchRequest& request)
      : classes_(classes),
        distances_(distances),
        bound_(bound),
        texels_(texels),
        center_(center),
        size_(classes.width(), classes.height()),
        turns_(turns),
        request_(request) {}

  Candidates run() {
    Candidates found = promising(all_bounds());
    measure(found);

    // What lies around the best, in ever smaller steps.
    SearchRequest wider = request_;
    wider.count += request_.count / 4;
    Candidates best = take_separated(found, size_, wider);
    for (int step = std::max(cell_px() / 2, 1); step >= 1; step /= 2) {
      Candidates around = neighbors(best, step);
      measure(around);
      for (size_t i = 0; i < best.size(); ++i)
        for (size_t n = 8 * i; n < 8 * (i + 1); ++n)
          if (around[n].error_sum < best[i].error_sum) best[i] = around[n];
      found.insert(found.end(), around.begin(), around.end());
    }
    return take_separated(found, size_, request_);
  }

  uint64_t error_count() const { return error_count_; }

 private:
  int cell_px() const {
    return (std::max(size_.x, size_.y) - 1) / std::max(bound_.grid().cells.x, bound_.grid().cells.y) + 1;
  }

  // For each turn, of the contents that bring a cell to the center.
  std::vector<Image<float>> all_bounds() const {
    std::vector<Image<float>> bounds(turns_.size());
    std::vector<int> first_halves;
    for (size_t i = 0; i < turns_.size(); ++i)
      if (turns_[i].rotation_eighths < 4) first_halves.push_back(static_cast<int>(i));
    parallel_for(0, static_cast<int>(first_halves.size()), [&](int i) {
      const auto first = static_cast<size_t>(first_halves[static_cast<size_t>(i)]);
      auto [turned, half_turned] = bound_.bounds(texels_.border, turns_[first]);
      bounds[first] = std::move(turned);
      for (size_t other = first + 1; other < turns_.size(); ++other)
        if (turns_[other].scale == turns_[first].scale &&
            turns_[other].rotation_eighths == turns_[first].rotation_eighths + 4)
          bounds[other] = std::move(half_turned);
    });
    return bounds;
  }

  Candidate at_cell(V2i cell, int turn, float bound) const {
    return {wrap(bound_.grid().middle_px(cell) - center_, size_), static_cast<uint64_t>(std::max(bound, 0.0f)), turn};
  }

  // The least of the minima of all bounds, and enough that are far apart.
  Candidates promising(const std::vector<Image<float>>& bounds) const {
    Candidates minima, least;
    const V2i cells = bound_.grid().cells;
    for (int y = 0; y < cells.y; ++y)
      for (int x = 0; x < cells.x; ++x) {
        if (!far_enough(at_cell({x, y}, 0, 0).translation, {0, 0}, size_, request_.separation_px)) continue;
        size_t least_turn = 0;
        for (size_t turn = 0; turn < bounds.size(); ++turn) {
          if (bounds[turn](x, y) < bounds[least_turn](x, y)) least_turn = turn;
          if (is_minimum(bounds[turn], {x, y}))
            minima.push_back(at_cell({x, y}, static_cast<int>(turn), bounds[turn](x, y)));
        }
        least.push_back(at_cell({x, y}, static_cast<int>(least_turn), bounds[least_turn](x, y)));
      }
    if (minima.size() > kBestBounds) {
      std::nth_element(minima.begin(), minima.begin() + kBestBounds, minima.end(), before);
      minima.resize(kBestBounds);
    }
    Candidates apart = take_separated(least, size_, {2 * request_.count, request_.separation_px});
    minima.insert(minima.end(), apart.begin(), apart.end());
    std::sort(minima.begin(), minima.end(), [](const Candidate& a, const Candidate& b) {
      return a.turn != b.turn ? a.turn < b.turn : before(a, b);  // one turn after the other
    });
    return minima;
  }

  static bool before(const Candidate& a, const Candidate& b) {
    return std::tuple(a.error_sum, a.translation.y, a.translation.x, a.turn) <
           std::tuple(b.error_sum, b.translation.y, b.translation.x, b.turn);
  }

  static bool is_minimum(const Image<float>& bound, V2i cell) {
    const V2i size(bound.width(), bound.height());
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const V2i other = wrap(cell + V2i(dx, dy), size);
        if (bound(other.x, other.y) < bound(cell.x, cell.y)) return false;
      }
    return true;
  }

  Candidates neighbors(const Candidates& candidates, int step) const {
    Candidates around;
    for (const Candidate& candidate : candidates)
      for (int dy = -step; dy <= step; dy += step)
        for (int dx = -step; dx <= step; dx += step)
          if (dx != 0 || dy != 0)
            around.push_back({wrap(candidate.translation + V2i(dx, dy), size_), 0, candidate.turn});
    return around;
  }

  // Computes the errors.
  void measure(Candidates& candidates) {
    const int count = static_cast<int>(candidates.size());
    parallel_for(0, kTasks, [&](int task) {
      TurnedImpact impact(classes_, distances_, texels_.offsets, center_);
      for (int i = count * task / kTasks; i < count * (task + 1) / kTasks; ++i) {
        Candidate& candidate = candidates[static_cast<size_t>(i)];
        Content content = turns_[static_cast<size_t>(candidate.turn)];
        content.translation = candidate.translation;
        candidate.error_sum = impact.error_sum(content);
      }
    });
    error_count_ += candidates.size() * texels_.offsets.size();
  }

  ImageView<const uint8_t> classes_;
  const ClassDistances& distances_;
  const TurnedBound& bound_;
  const PatchTexels& texels_;
  V2i center_;
  V2i size_;
  const Turns& turns_;
  SearchRequest request_;
  uint64_t error_count_ = 0;
};

}  // namespace

Turns make_turns(int rotations, int scales, float min_scale) {
  assert(rotations == 1 || rotations == 2 || rotations == 4 || rotations == 8);
  Turns turns;
  for (int i = 0; i < scales; ++i) {
    const float share = scales > 1 ? static_cast<float>(i) / static_cast<float>(scales - 1) : 0.0f;
    const float scale = std::floor(64.0f * (1.0f - share * (1.0f - min_scale)) + 0.5f) / 64.0f;
    if (!turns.empty() && turns.back().scale == scale) continue;
    for (int r = 0; r < rotations; ++r) turns.push_back(make_content({0, 0}, 8 / rotations * r, scale));
  }
  return turns;
}

SearchResult search_contents_turned(ImageView<const uint8_t> classes, const ClassDistances& distances,
                                    const Partition& patches, const Turns& turns, const SearchRequest& request,
                                    const Progress& progress) {
  const PatchBorders borders = patch_borders(patches.idx, patches.count());
  const TurnedBound bound(classes, distances);
  const auto texels = texels_of_patches(classes, borders, patches);
  SearchResult result;
  for (size_t patch = 0; patch < texels.size(); ++patch) {
    PatchSearch search(classes, distances, bound, texels[patch], patches.centers[patch], turns, request);
    result.candidates.push_back(search.run());
    result.error_count += search.error_count();
    result.all_error_count += texels[patch].offsets.size() * classes.size() * turns.size();
    report_progress(progress, static_cast<double>(patch + 1) / static_cast<double>(texels.size()));
  }
  return result;
}

}  // namespace texbake
