#include "libbake/content/border_steps.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "libbake/base/parallel.h"
#include "libbake/content/shown_source.h"

namespace texbake {
namespace {

constexpr size_t kPairsPerBorder = 128;
constexpr float kStepsPerDeltaE = 16;
constexpr int64_t kOne = 1 << 20;
constexpr int kGrain = 8;  // numbers in one task

}  // namespace

BorderSteps::BorderSteps(const std::vector<std::vector<Content>>& numbered, ImageView<const V3f> base_luv,
                         const Partition& patches)
    : numbered_(numbered), luv_(base_luv), patches_(patches), sides_(numbered.size()), counts_(numbered.size(), 0) {
  find_sides();
  weigh_steps();
  for (const std::vector<Content>& contents : numbered) sums_.emplace_back(contents.size(), 0);
}

int BorderSteps::step(const V3f& a, const V3f& b) const {
  return static_cast<int>(std::min((a - b).length() * kStepsPerDeltaE, static_cast<float>(kSteps - 1)));
}

V3f BorderSteps::shown(size_t patch, V2i p, size_t number) const {
  const V2i source = shown_source(patches_, static_cast<uint32_t>(patch), p, numbered_[patch][number]);
  return luv_(source.x, source.y);
}

void BorderSteps::find_sides() {
  const V2i size = patches_.size();
  std::map<std::pair<uint32_t, uint32_t>, Side> found;  // by the lower and the higher patch
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (const V2i& step : {V2i(1, 0), V2i(0, 1)}) {
        V2i p(x, y);
        V2i q = wrap(p + step, size);
        if (patches_.idx(p.x, p.y) == patches_.idx(q.x, q.y)) continue;
        if (patches_.idx(p.x, p.y) > patches_.idx(q.x, q.y)) std::swap(p, q);
        Side& side = found[{patches_.idx(p.x, p.y), patches_.idx(q.x, q.y)}];
        side.inside.push_back(p);
        side.outside.push_back(q);
      }
  for (const auto& [pair, all] : found) {
    Side side{pair.second, {}, {}};
    const size_t kept = std::min(all.inside.size(), kPairsPerBorder);
    for (size_t i = 0; i < kept; ++i) {
      side.inside.push_back(all.inside[i * all.inside.size() / kept]);
      side.outside.push_back(all.outside[i * all.inside.size() / kept]);
    }
    sides_[pair.second].push_back({pair.first, side.outside, side.inside});
    sides_[pair.first].push_back(std::move(side));
  }
}

void BorderSteps::weigh_steps() {
  std::array<int64_t, kSteps> own{};
  for (const std::vector<Side>& sides : sides_)
    for (const Side& side : sides)
      for (size_t i = 0; i < side.inside.size(); ++i)
        ++own[static_cast<size_t>(
            step(luv_(side.inside[i].x, side.inside[i].y), luv_(side.outside[i].x, side.outside[i].y)))];
  const int64_t count = std::max(std::accumulate(own.begin(), own.end(), int64_t{0}), int64_t{1});
  int64_t below = 0;
  for (size_t i = 0; i < own.size(); ++i) {
    const bool is_strong = 100 * below >= 95 * count;
    visibility_[i] = kOne * (2 * below + own[i]) / (2 * count) + (is_strong ? kOne / 2 : 0);
    below += own[i];
  }
}

void BorderSteps::change(size_t patch, size_t number, int sign) {
  for (const Side& side : sides_[patch]) {
    std::vector<V3f> colors;
    for (const V2i& p : side.inside) colors.push_back(shown(patch, p, number));
    std::vector<int64_t>& sums = sums_[side.other];
    parallel_for(
        0, static_cast<int>(sums.size()),
        [&](int other) {
          int64_t sum = 0;
          for (size_t i = 0; i < colors.size(); ++i) {
            const V3f beyond = shown(side.other, side.outside[i], static_cast<size_t>(other));
            sum += visibility_[static_cast<size_t>(step(colors[i], beyond))];
          }
          sums[static_cast<size_t>(other)] += sign * sum;
        },
        kGrain);
    counts_[side.other] += sign * static_cast<int64_t>(colors.size());
  }
}

double BorderSteps::visibility(size_t patch, size_t number) const {
  if (counts_[patch] == 0) return 0.0;
  return static_cast<double>(sums_[patch][number]) / static_cast<double>(kOne * counts_[patch]);
}

}  // namespace texbake
