#include "libbake/content/choice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

constexpr int kLowCells = 64;  // along the shorter side: σ = 1/16 of it is four cells
constexpr int kMaxPasses = 12;

// The tile seen from afar: block means, smoothed, less their mean.
struct LowPassed {
  int block_px = 1;
  Image<V3f> color;   // z of each cell
  double energy = 0;  // mean |z|² over the tile
};

LowPassed low_passed(ImageView<const V3f> luv) {
  LowPassed low;
  const int side = std::min(luv.width(), luv.height());
  while (side / (2 * low.block_px) >= kLowCells && luv.width() % (2 * low.block_px) == 0 &&
         luv.height() % (2 * low.block_px) == 0)
    low.block_px *= 2;
  Image<V3f> cells(luv.width() / low.block_px, luv.height() / low.block_px);
  const float share = 1.0f / static_cast<float>(low.block_px * low.block_px);
  parallel_for(0, cells.height(), [&](int y) {
    for (int x = 0; x < cells.width(); ++x)
      for (int j = 0; j < low.block_px; ++j)
        for (int i = 0; i < low.block_px; ++i) cells(x, y) += luv(x * low.block_px + i, y * low.block_px + j) * share;
  });
  low.color = gaussian_blur(cells, side / 16.0 / low.block_px, Wrap::repeat);
  double mean[3] = {};
  for (const V3f& c : low.color)
    for (int i = 0; i < 3; ++i) mean[i] += static_cast<double>(c[i]) / static_cast<double>(low.color.size());
  for (V3f& c : low.color) {
    c -= V3f(static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2]));
    low.energy += static_cast<double>(c.length2()) / static_cast<double>(low.color.size());
  }
  return low;
}

// Cells whose middle texel belongs to each patch.
std::vector<std::vector<V2i>> cells_of_patches(const Partition& patches, const LowPassed& low) {
  std::vector<std::vector<V2i>> cells(static_cast<size_t>(patches.count()));
  for (int y = 0; y < low.color.height(); ++y)
    for (int x = 0; x < low.color.width(); ++x) {
      const int middle = low.block_px / 2;
      cells[patches.idx(x * low.block_px + middle, y * low.block_px + middle)].emplace_back(x, y);
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
  BalancedChoice(const std::vector<Candidates>& candidates, ImageView<const V3f> luv, const Partition& patches,
                 const ChoiceWeights& weights)
      : low_(low_passed(luv)), weights_(weights), use_(low_.color.width(), low_.color.height()) {
    const auto cells = cells_of_patches(patches, low_);
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
    double cost = INFINITY;
  };

  V3f z(const PatchState& patch, int number, size_t cell) const {
    const V2i p = wrap(patch.cells[cell] + patch.shifts[static_cast<size_t>(number)], size());
    return low_.color(p.x, p.y);
  }
  V2i size() const { return {low_.color.width(), low_.color.height()}; }

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
      const int half = low_.block_px / 2;
      patch.shifts.emplace_back((candidate.translation.x + half) / low_.block_px,
                                (candidate.translation.y + half) / low_.block_px);
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
      const V2i p = wrap(cell + patch.shifts[static_cast<size_t>(number)], size());
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
      const V2i p = wrap(patch.cells[i] + patch.shifts[static_cast<size_t>(number)], size());
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
    std::vector<double> costs(static_cast<size_t>(numbers), INFINITY);
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

// Σ_P Σ_{x∈P} |mean_c z_c|² / Σ_P Σ_{x∈P} mean_c |z_c|².
double predicted_repetition(const std::vector<std::vector<V2i>>& translations, ImageView<const V3f> luv,
                            ImageView<const uint32_t> patch_idx) {
  const V2i size(luv.width(), luv.height());
  double mean[3] = {};
  for (const V3f& c : luv)
    for (int i = 0; i < 3; ++i) mean[i] += static_cast<double>(c[i]) / static_cast<double>(luv.size());
  const V3f center(static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2]));
  std::vector<std::pair<double, double>> rows(static_cast<size_t>(size.y));
  parallel_for(0, size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      const auto& contents = translations[patch_idx(x, y)];
      V3f sum(0);
      double energy = 0.0;
      for (const V2i& t : contents) {
        const V2i p = wrap(V2i(x, y) + t, size);
        const V3f z = luv(p.x, p.y) - center;
        sum += z;
        energy += static_cast<double>(z.length2());
      }
      const auto n = static_cast<double>(contents.size());
      rows[static_cast<size_t>(y)].first += static_cast<double>(sum.length2()) / (n * n);
      rows[static_cast<size_t>(y)].second += energy / n;
    }
  });
  double shared = 0.0, all = 0.0;
  for (const auto& [row_shared, row_all] : rows) {
    shared += row_shared;
    all += row_all;
  }
  return all > 0.0 ? shared / all : 0.0;
}

double use_deviation(const std::vector<std::vector<V2i>>& translations, ImageView<const uint32_t> patch_idx) {
  const V2i size(patch_idx.width(), patch_idx.height());
  Image<int> use(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (const V2i& t : translations[patch_idx(x, y)]) {
        const V2i p = wrap(V2i(x, y) + t, size);
        ++use(p.x, p.y);
      }
  double sum = 0.0, squares = 0.0;
  for (const int u : use) {
    sum += u;
    squares += static_cast<double>(u) * u;
  }
  const auto n = static_cast<double>(use.size());
  return std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0)) / (sum / n);
}

}  // namespace

ChosenCandidates choose_least_impact(const std::vector<Candidates>& candidates, int wanted) {
  std::vector<int> first(static_cast<size_t>(wanted));
  std::iota(first.begin(), first.end(), 0);
  return ChosenCandidates(candidates.size(), first);
}

ChosenCandidates choose_balanced(const std::vector<Candidates>& candidates, int wanted, ImageView<const V3f> base_luv,
                                 const Partition& patches, uint32_t seed, const ChoiceWeights& weights) {
  return BalancedChoice(candidates, base_luv, patches, weights).choose(wanted, seed);
}

ChoiceFigures choice_figures(const std::vector<std::vector<V2i>>& translations, ImageView<const V3f> base_luv,
                             const Partition& patches) {
  ChoiceFigures figures;
  figures.repetition_near = predicted_repetition(translations, base_luv, patches.idx);
  const double far_px = std::min(base_luv.width(), base_luv.height()) / 16.0;
  const LowPassed low = low_passed(base_luv);
  if (low.block_px == 1) {
    figures.repetition_far =
        predicted_repetition(translations, gaussian_blur(base_luv, far_px, Wrap::repeat), patches.idx);
  } else {
    // The same at the reduced size.
    Image<uint32_t> idx(low.color.width(), low.color.height());
    for (int y = 0; y < idx.height(); ++y)
      for (int x = 0; x < idx.width(); ++x)
        idx(x, y) = patches.idx(x * low.block_px + low.block_px / 2, y * low.block_px + low.block_px / 2);
    std::vector<std::vector<V2i>> reduced;
    for (const auto& contents : translations) {
      reduced.emplace_back();
      for (const V2i& t : contents) {
        const V2i positive = wrap(t, V2i(base_luv.width(), base_luv.height())) + V2i(low.block_px / 2);
        reduced.back().push_back(positive / low.block_px);
      }
    }
    figures.repetition_far = predicted_repetition(reduced, low.color, idx);
  }
  figures.use_deviation = use_deviation(translations, patches.idx);
  return figures;
}

}  // namespace texbake
