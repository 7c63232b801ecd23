#include "libbake/content/choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"
#include "libbake/content/border_steps.h"
#include "libbake/content/low_passed.h"
#include "libbake/content/shown_source.h"

namespace texbake {
namespace {

constexpr int kMaxPasses = 12;

// Content numbers: 0 is the identity, 1 + i is candidate i.
std::vector<std::vector<Content>> numbered(const ContentCandidates& candidates) {
  std::vector<std::vector<Content>> contents;
  for (const std::vector<Content>& of_patch : candidates) {
    contents.emplace_back(1, Content{});
    contents.back().insert(contents.back().end(), of_patch.begin(), of_patch.end());
  }
  return contents;
}

// Everything that the balanced choice knows of one patch.
struct PatchState {
  std::vector<V2i> middles_px;               // of the cells whose middle texel belongs to the patch
  std::vector<std::vector<uint32_t>> cells;  // that show there, with every content number
  std::vector<std::vector<V3f>> colors;      // z_c of the cells
  std::vector<double> energies;              // Σ_x |z|² of every content number
  std::vector<double> impacts;               // relative to the mean over the candidates
  std::vector<int> chosen;                   // content numbers, the identity first
  std::vector<V3f> sum;                      // Σ_c z_c(x) over the chosen
  double energy_sum = 0;                     // Σ_c Σ_x |z_c|²
};

class BalancedChoice {
 public:
  BalancedChoice(const ContentCandidates& candidates, ImageView<const V3f> luv, const Partition& patches,
                 const ChoiceWeights& weights)
      : low_(low_passed(luv)),
        weights_(weights),
        use_(low_.color.size(), 0),
        patches_(candidates.size()),
        numbered_(numbered(candidates)),
        steps_(numbered_, luv, patches) {
    for (int y = 0; y < low_.grid.cells.y; ++y)
      for (int x = 0; x < low_.grid.cells.x; ++x) {
        const V2i p = low_.grid.middle_px({x, y});
        patches_[patches.idx(p.x, p.y)].middles_px.push_back(p);
      }
    std::map<float, LowPassed> low_of_scale;
    for (size_t p = 0; p < candidates.size(); ++p) {
      PatchState& patch = patches_[p];
      patch.sum.assign(patch.middles_px.size(), V3f(0));
      add_number(patches, static_cast<uint32_t>(p), Content{}, low_);
      for (const Content& candidate : candidates[p]) {
        auto low = low_of_scale.find(candidate.scale);
        if (low == low_of_scale.end())
          low = low_of_scale.emplace(candidate.scale, low_passed(luv, candidate.scale)).first;
        add_number(patches, static_cast<uint32_t>(p), candidate, low->second);
      }
      find_impacts(candidates[p], patch);
    }
  }

  ChosenCandidates choose(int wanted, uint32_t seed) {
    mean_use_ = static_cast<double>(wanted + 1);
    for (size_t p = 0; p < patches_.size(); ++p) {
      add(patches_[p], 0);
      steps_.add(p, 0);
    }
    std::vector<size_t> order(patches_.size());
    std::iota(order.begin(), order.end(), size_t{0});
    Random random(seed, 7);
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<uint32_t>(i))]);

    // Greedy: one more content for every patch in turn, so that all patches share the use of the exemplar.
    for (int round = 0; round < wanted; ++round)
      for (const size_t p : order) {
        const int number = best_addition(p).number;
        add(patches_[p], number);
        steps_.add(p, static_cast<size_t>(number));
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

  void add_number(const Partition& patches, uint32_t idx, const Content& content, const LowPassed& low) {
    PatchState& patch = patches_[idx];
    std::vector<uint32_t>& cells = patch.cells.emplace_back();
    std::vector<V3f>& colors = patch.colors.emplace_back();
    double energy = 0.0;
    for (const V2i& p : patch.middles_px) {
      const V2i source = shown_source(patches, idx, p, content);
      const V2i cell = low.grid.cell_of(source);
      cells.push_back(static_cast<uint32_t>(cell.y * low.grid.cells.x + cell.x));
      colors.push_back(low.at(source));
      energy += static_cast<double>(colors.back().length2());
    }
    patch.energies.push_back(energy);
  }

  static void find_impacts(const std::vector<Content>& candidates, PatchState& patch) {
    double mean = 0.0;
    for (const Content& candidate : candidates)
      mean += static_cast<double>(candidate.impact) / static_cast<double>(candidates.size());
    patch.impacts.push_back(0.0);
    for (const Content& candidate : candidates)
      patch.impacts.push_back(mean > 0.0 ? static_cast<double>(candidate.impact) / mean : 0.0);
  }

  void count_use(const PatchState& patch, int number, int change) {
    for (const uint32_t cell : patch.cells[static_cast<size_t>(number)]) use_[cell] += change;
  }
  void add(PatchState& patch, int number) {
    patch.chosen.push_back(number);
    const std::vector<V3f>& z = patch.colors[static_cast<size_t>(number)];
    for (size_t i = 0; i < z.size(); ++i) patch.sum[i] += z[i];
    patch.energy_sum += patch.energies[static_cast<size_t>(number)];
    count_use(patch, number, 1);
  }
  void remove(PatchState& patch, int number) {
    patch.chosen.erase(std::find(patch.chosen.begin(), patch.chosen.end(), number));
    const std::vector<V3f>& z = patch.colors[static_cast<size_t>(number)];
    for (size_t i = 0; i < z.size(); ++i) patch.sum[i] -= z[i];
    patch.energy_sum -= patch.energies[static_cast<size_t>(number)];
    count_use(patch, number, -1);
  }

  // What the objective rises by when `number` joins the patch, less what does not depend on `number`.
  double cost_of(size_t p, int number) const {
    const PatchState& patch = patches_[p];
    const auto count = static_cast<double>(patch.chosen.size() + 1);
    double mean_energy = 0.0;
    double use = 0.0;
    const std::vector<V3f>& z = patch.colors[static_cast<size_t>(number)];
    const std::vector<uint32_t>& cells = patch.cells[static_cast<size_t>(number)];
    for (size_t i = 0; i < z.size(); ++i) {
      mean_energy += static_cast<double>((patch.sum[i] + z[i]).length2());
      use += 2.0 * (static_cast<double>(use_[cells[i]]) - mean_use_) + 1.0;  // (u + 1 − m)² − (u − m)²
    }
    mean_energy /= count * count;
    const double energy = (patch.energy_sum + patch.energies[static_cast<size_t>(number)]) / count;
    const double tile_energy = low_.energy * static_cast<double>(z.size());
    // The step at a border is shared by two patches.
    double cost = weights_.impact * patch.impacts[static_cast<size_t>(number)] +
                  weights_.steps * 2.0 / mean_use_ * steps_.visibility(p, static_cast<size_t>(number));
    if (energy > 0.0 && tile_energy > 0.0)
      cost += mean_energy / energy + 0.5 * std::fabs(portable_log(energy / tile_energy));
    const auto places = static_cast<double>(use_.size());
    return cost + weights_.use * static_cast<double>(patches_.size()) * use / (places * mean_use_ * mean_use_);
  }

  Addition best_addition(size_t p) const {
    const PatchState& patch = patches_[p];
    const int numbers = static_cast<int>(patch.cells.size());
    std::vector<double> costs(static_cast<size_t>(numbers), Addition{}.cost);
    parallel_for(1, numbers, [&](int number) {
      if (std::find(patch.chosen.begin(), patch.chosen.end(), number) == patch.chosen.end())
        costs[static_cast<size_t>(number)] = cost_of(p, number);
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
        const double kept = cost_of(p, number);
        const Addition other = best_addition(p);
        const bool better = other.cost < kept - 1e-9;
        add(patch, better ? other.number : number);
        if (!better) continue;
        steps_.remove(p, static_cast<size_t>(number));
        steps_.add(p, static_cast<size_t>(other.number));
        improved = true;
      }
    }
    return improved;
  }

  LowPassed low_;
  ChoiceWeights weights_;
  std::vector<int> use_;  // of each cell
  std::vector<PatchState> patches_;
  std::vector<std::vector<Content>> numbered_;
  BorderSteps steps_;
  double mean_use_ = 1;
};

}  // namespace

ChosenCandidates choose_least_impact(const ContentCandidates& candidates, int wanted) {
  std::vector<int> first(static_cast<size_t>(wanted));
  std::iota(first.begin(), first.end(), 0);
  return ChosenCandidates(candidates.size(), first);
}

ChosenCandidates choose_balanced(const ContentCandidates& candidates, int wanted, ImageView<const V3f> base_luv,
                                 const Partition& patches, uint32_t seed, const ChoiceWeights& weights) {
  return BalancedChoice(candidates, base_luv, patches, weights).choose(wanted, seed);
}

}  // namespace texbake
