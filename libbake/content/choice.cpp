#include "libbake/content/choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"
#include "libbake/content/border_steps.h"
#include "libbake/content/cell_grid.h"
#include "libbake/content/far_view.h"
#include "libbake/content/shown_source.h"

namespace texbake {
namespace {

constexpr int kMaxPasses = 12;
constexpr double kUnseen = 0.2;  // ΔE, amplitude: less is not seen from afar, however flat the tile
constexpr int kUseCells = 64;    // along the tile's shorter side, in which use is counted

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
  std::vector<FarField> shown;               // with every content number
  std::vector<double> energies;              // of `shown`, from afar
  std::vector<double> farther_energies;      // and from farther still
  std::vector<double> impacts;               // relative to the mean over the candidates
  std::vector<int> chosen;                   // content numbers, the identity first
  FarField sum;                              // of `shown` over the chosen
  double energy_sum = 0;                     // of `energies` over the chosen
  double farther_sum = 0;                    // of `farther_energies`
};

class BalancedChoice {
 public:
  BalancedChoice(const ContentCandidates& candidates, ImageView<const V3f> luv, const Partition& patches,
                 const ChoiceWeights& weights)
      : view_(luv, patches),
        grid_(CellGrid::of(patches.size(), kUseCells)),
        weights_(weights),
        use_(static_cast<size_t>(grid_.cells.x * grid_.cells.y), 0),
        patches_(candidates.size()),
        mean_(view_.blank()),
        unseen_(kUnseen * kUnseen * static_cast<double>(mean_.colors.size())),
        numbered_(numbered(candidates)),
        steps_(numbered_, luv, patches) {
    for (int y = 0; y < grid_.cells.y; ++y)
      for (int x = 0; x < grid_.cells.x; ++x) {
        const V2i p = grid_.middle_px({x, y});
        patches_[patches.idx(p.x, p.y)].middles_px.push_back(p);
      }
    parallel_for(0, static_cast<int>(patches_.size()), [&](int p) {
      PatchState& patch = patches_[static_cast<size_t>(p)];
      for (const Content& content : numbered_[static_cast<size_t>(p)])
        add_number(patches, static_cast<uint32_t>(p), content);
      patch.sum = patch.shown[0];
      patch.sum *= 0.0f;
      find_impacts(candidates[static_cast<size_t>(p)], patch);
    });
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

  void add_number(const Partition& patches, uint32_t idx, const Content& content) {
    PatchState& patch = patches_[idx];
    std::vector<uint32_t>& cells = patch.cells.emplace_back();
    for (const V2i& p : patch.middles_px) {
      const V2i cell = grid_.cell_of(shown_source(patches, idx, p, content));
      cells.push_back(static_cast<uint32_t>(cell.y * grid_.cells.x + cell.x));
    }
    patch.shown.push_back(view_.shown(idx, content));
    patch.energies.push_back(view_.energy(patch.shown.back()));
    patch.farther_energies.push_back(view_.energy(patch.shown.back(), FarBlur::farther));
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
  // What the patch shows, averaged over its contents, is part of the mean of the whole.
  void add_to_mean(const PatchState& patch, float sign) {
    if (patch.chosen.empty()) return;
    FarField part = patch.sum;
    part *= sign / static_cast<float>(patch.chosen.size());
    view_.add(part, mean_);
  }
  void add(PatchState& patch, int number) {
    add_to_mean(patch, -1.0f);
    patch.chosen.push_back(number);
    patch.sum += patch.shown[static_cast<size_t>(number)];
    patch.energy_sum += patch.energies[static_cast<size_t>(number)];
    patch.farther_sum += patch.farther_energies[static_cast<size_t>(number)];
    add_to_mean(patch, 1.0f);
    count_use(patch, number, 1);
  }
  void remove(PatchState& patch, int number) {
    add_to_mean(patch, -1.0f);
    patch.chosen.erase(std::find(patch.chosen.begin(), patch.chosen.end(), number));
    FarField gone = patch.shown[static_cast<size_t>(number)];
    gone *= -1.0f;
    patch.sum += gone;
    patch.energy_sum -= patch.energies[static_cast<size_t>(number)];
    patch.farther_sum -= patch.farther_energies[static_cast<size_t>(number)];
    add_to_mean(patch, 1.0f);
    count_use(patch, number, -1);
  }

  // B² of the mean of the whole, at the cells of a patch, if it had one content more that shows nothing.
  FarField surroundings(const PatchState& patch) const {
    FarField change = patch.sum;
    const auto count = static_cast<float>(patch.chosen.size());
    change *= 1.0f / (count + 1.0f) - 1.0f / count;
    FarField rest = mean_;
    view_.add(change, rest);
    return view_.blurred_twice(rest, patch.sum);
  }

  // What the objective rises by when `number` joins the patch, less what does not depend on `number`.
  double cost_of(size_t p, int number, const FarField& surroundings) const {
    const PatchState& patch = patches_[p];
    const auto n = static_cast<size_t>(number);
    const auto count = static_cast<double>(patch.chosen.size() + 1);
    double use = 0.0;
    for (const uint32_t cell : patch.cells[n])
      use += 2.0 * (static_cast<double>(use_[cell]) - mean_use_) + 1.0;  // (u + 1 − m)² − (u − m)²
    const auto patch_count = static_cast<double>(patches_.size());
    // The step at a border is shared by two patches.
    const double cost = weights_.impact * patch.impacts[n] +
                        weights_.steps * 2.0 / mean_use_ * steps_.visibility(p, n) +
                        weights_.use * patch_count * use / (static_cast<double>(use_.size()) * mean_use_ * mean_use_);
    const double repeating = 2.0 * dot(surroundings, patch.shown[n]) / count + patch.energies[n] / (count * count);
    const double share = view_.share_of(static_cast<uint32_t>(p));
    const auto unlike = [&](double energy, double of_tile) {
      return share > 0.0 ? std::fabs(portable_log((energy / share + unseen_) / (of_tile + unseen_))) : 0.0;
    };
    return cost + weights_.balance * patch_count * repeating / (view_.tile_energy() + unseen_) +
           weights_.energy * unlike((patch.energy_sum + patch.energies[n]) / count, view_.tile_energy()) +
           weights_.farther_energy *
               unlike((patch.farther_sum + patch.farther_energies[n]) / count, view_.tile_energy(FarBlur::farther));
  }

  Addition best_addition(size_t p) const {
    const PatchState& patch = patches_[p];
    const FarField around = surroundings(patch);
    const int numbers = static_cast<int>(patch.cells.size());
    std::vector<double> costs(static_cast<size_t>(numbers), Addition{}.cost);
    parallel_for(1, numbers, [&](int number) {
      if (std::find(patch.chosen.begin(), patch.chosen.end(), number) == patch.chosen.end())
        costs[static_cast<size_t>(number)] = cost_of(p, number, around);
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
        const double kept = cost_of(p, number, surroundings(patch));
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

  FarView view_;
  CellGrid grid_;
  ChoiceWeights weights_;
  std::vector<int> use_;  // of each cell
  std::vector<PatchState> patches_;
  FarField mean_;  // what all patches show, averaged over their contents
  double unseen_;  // energy of the whole
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
