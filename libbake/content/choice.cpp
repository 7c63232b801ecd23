#include "libbake/content/choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"
#include "libbake/content/low_passed.h"

namespace texbake {
namespace {

constexpr int kMaxPasses = 12;

// Cells whose middle texel belongs to each patch.
std::vector<std::vector<V2i>> cells_of_patches(ImageView<const uint32_t> patch_idx, size_t patch_count,
                                               const LowPassed& low) {
  std::vector<std::vector<V2i>> cells(patch_count);
  for (int y = 0; y < low.cells().y; ++y)
    for (int x = 0; x < low.cells().x; ++x) {
      const V2i p = low.middle_px({x, y});
      cells[patch_idx(p.x, p.y)].emplace_back(x, y);
    }
  return cells;
}

// Everything that the balanced choice knows of one patch. Content numbers: 0 is the identity, 1 + i is candidate i.
struct PatchState {
  std::vector<V2i> cells;
  std::vector<V2i> shifts;       // in cells, of every content number
  std::vector<double> energies;  // Σ_x |z|² of every content number
  std::vector<double> impacts;   // relative to the mean over the candidates
  std::vector<int> chosen;       // content numbers, the identity first
  std::vector<V3f> sum;          // Σ_c z_c(x) over the chosen
  double energy_sum = 0;         // Σ_c Σ_x |z_c|²
};

class BalancedChoice {
 public:
  BalancedChoice(const std::vector<Candidates>& candidates, ImageView<const V3f> luv,
                 ImageView<const uint32_t> patch_idx, const ChoiceWeights& weights)
      : low_(low_passed(luv)), weights_(weights), use_(low_.color.width(), low_.color.height()) {
    const auto cells = cells_of_patches(patch_idx, candidates.size(), low_);
    for (size_t p = 0; p < candidates.size(); ++p) patches_.push_back(make_patch(cells[p], candidates[p]));
  }

  ChosenCandidates choose(int wanted, uint32_t seed) {
    mean_use_ = static_cast<double>(wanted + 1);
    for (PatchState& patch : patches_) add(patch, 0);
    std::vector<size_t> order(patches_.size());
    std::iota(order.begin(), order.end(), size_t{0});
    Random random(seed, 7);
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<uint32_t>(i))]);

    // Greedy: one more content for every patch in turn, so that all patches share the use of the exemplar.
    for (int round = 0; round < wanted; ++round)
      for (const size_t p : order) {
        PatchState& patch = patches_[p];
        add(patch, best_addition(patch).number);
      }
    // Exchange one content at a time for a better one.
    for (int pass = 0; pass < kMaxPasses && exchange_all(order); ++pass) {
    }

    ChosenCandidates chosen;
    for (const PatchState& patch : patches_) {
      chosen.emplace_back();
      for (const int number : patch.chosen)
        if (number > 0) chosen.back().push_back(number - 1);
      std::sort(chosen.back().begin(), chosen.back().end());
    }
    return chosen;
  }

 private:
  struct Addition {
    int number = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  V3f z(const PatchState& patch, int number, size_t cell) const {
    const V2i p = wrap(patch.cells[cell] + patch.shifts[static_cast<size_t>(number)], low_.cells());
    return low_.color(p.x, p.y);
  }

  PatchState make_patch(const std::vector<V2i>& cells, const Candidates& candidates) const {
    PatchState patch;
    patch.cells = cells;
    patch.sum.assign(cells.size(), V3f(0));
    patch.shifts.emplace_back(0, 0);
    patch.impacts.push_back(0.0);
    double mean = 0.0;
    for (const Candidate& candidate : candidates)
      mean += static_cast<double>(candidate.error_sum) / static_cast<double>(candidates.size());
    for (const Candidate& candidate : candidates) {
      patch.shifts.push_back(low_.shift(candidate.translation));
      patch.impacts.push_back(mean > 0.0 ? static_cast<double>(candidate.error_sum) / mean : 0.0);
    }
    for (int number = 0; number < static_cast<int>(patch.shifts.size()); ++number) {
      double energy = 0.0;
      for (size_t i = 0; i < cells.size(); ++i) energy += static_cast<double>(z(patch, number, i).length2());
      patch.energies.push_back(energy);
    }
    return patch;
  }

  void count_use(const PatchState& patch, int number, int change) {
    for (const V2i& cell : patch.cells) {
      const V2i p = wrap(cell + patch.shifts[static_cast<size_t>(number)], low_.cells());
      use_(p.x, p.y) += change;
    }
  }
  void add(PatchState& patch, int number) {
    patch.chosen.push_back(number);
    for (size_t i = 0; i < patch.cells.size(); ++i) patch.sum[i] += z(patch, number, i);
    patch.energy_sum += patch.energies[static_cast<size_t>(number)];
    count_use(patch, number, 1);
  }
  void remove(PatchState& patch, int number) {
    patch.chosen.erase(std::find(patch.chosen.begin(), patch.chosen.end(), number));
    for (size_t i = 0; i < patch.cells.size(); ++i) patch.sum[i] -= z(patch, number, i);
    patch.energy_sum -= patch.energies[static_cast<size_t>(number)];
    count_use(patch, number, -1);
  }

  // What the objective rises by when `number` joins the patch, less what does not depend on `number`.
  double cost_of(const PatchState& patch, int number) const {
    const auto count = static_cast<double>(patch.chosen.size() + 1);
    double mean_energy = 0.0;
    double use = 0.0;
    for (size_t i = 0; i < patch.cells.size(); ++i) {
      mean_energy += static_cast<double>((patch.sum[i] + z(patch, number, i)).length2());
      const V2i p = wrap(patch.cells[i] + patch.shifts[static_cast<size_t>(number)], low_.cells());
      // (u + 1 − m)² − (u − m)²
      use += 2.0 * (static_cast<double>(use_(p.x, p.y)) - mean_use_) + 1.0;
    }
    mean_energy /= count * count;
    const double energy = (patch.energy_sum + patch.energies[static_cast<size_t>(number)]) / count;
    const double tile_energy = low_.energy * static_cast<double>(patch.cells.size());
    double cost = weights_.impact * patch.impacts[static_cast<size_t>(number)];
    if (energy > 0.0 && tile_energy > 0.0)
      cost += mean_energy / energy + 0.5 * std::fabs(portable_log(energy / tile_energy));
    const auto cells = static_cast<double>(use_.size());
    return cost + weights_.use * static_cast<double>(patches_.size()) * use / (cells * mean_use_ * mean_use_);
  }

  Addition best_addition(const PatchState& patch) const {
    const int numbers = static_cast<int>(patch.shifts.size());
    std::vector<double> costs(static_cast<size_t>(numbers), Addition{}.cost);
    parallel_for(1, numbers, [&](int number) {
      if (std::find(patch.chosen.begin(), patch.chosen.end(), number) == patch.chosen.end())
        costs[static_cast<size_t>(number)] = cost_of(patch, number);
    });
    const auto best = std::min_element(costs.begin(), costs.end());
    return {static_cast<int>(best - costs.begin()), *best};
  }

  bool exchange_all(const std::vector<size_t>& order) {
    bool improved = false;
    for (const size_t p : order) {
      PatchState& patch = patches_[p];
      const std::vector<int> before = patch.chosen;
      for (const int number : before) {
        if (number == 0) continue;
        remove(patch, number);
        const double kept = cost_of(patch, number);
        const Addition other = best_addition(patch);
        const bool better = other.cost < kept - 1e-9;
        add(patch, better ? other.number : number);
        improved = improved || better;
      }
    }
    return improved;
  }

  LowPassed low_;
  ChoiceWeights weights_;
  std::vector<PatchState> patches_;
  Image<int> use_;
  double mean_use_ = 1;
};

}  // namespace

ChosenCandidates choose_least_impact(const std::vector<Candidates>& candidates, int wanted) {
  std::vector<int> first(static_cast<size_t>(wanted));
  std::iota(first.begin(), first.end(), 0);
  return ChosenCandidates(candidates.size(), first);
}

ChosenCandidates choose_balanced(const std::vector<Candidates>& candidates, int wanted, ImageView<const V3f> base_luv,
                                 ImageView<const uint32_t> patch_idx, uint32_t seed, const ChoiceWeights& weights) {
  return BalancedChoice(candidates, base_luv, patch_idx, weights).choose(wanted, seed);
}

}  // namespace texbake
