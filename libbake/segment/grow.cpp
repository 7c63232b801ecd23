#include "libbake/segment/grow.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "libbake/base/random.h"
#include "libbake/segment/neighbors.h"
#include "libbake/segment/torus_box.h"

namespace texbake {
namespace {

/// A texel that was refused, and its variation.
struct Refused {
  float v;
  size_t at;
};
struct LowestFirst {
  bool operator()(const Refused& a, const Refused& b) const { return a.v != b.v ? a.v > b.v : a.at > b.at; }
};
struct HighestFirst {
  bool operator()(const Refused& a, const Refused& b) const { return a.v != b.v ? a.v < b.v : a.at > b.at; }
};

class Grower {
 public:
  Grower(const Image<uint8_t>& index, const Image<float>& variation, const GrowthLimits& limits)
      : index_(index),
        variation_(variation),
        limits_(limits),
        size_(index.width(), index.height()),
        random_(limits.seed),
        asked_by_(index.size(), kFree),
        in_frontier_(index.size(), 0) {
    growth_.idx = Image<uint32_t>(size_.x, size_.y, kFree);
  }

  Growth run() {
    grow_from(random_.below(static_cast<uint32_t>(index_.size())));
    while (!frontier_.empty()) {
      const uint32_t pick = random_.below(static_cast<uint32_t>(frontier_.size()));
      const size_t seed = frontier_[pick];
      frontier_[pick] = frontier_.back();
      frontier_.pop_back();
      if (growth_.idx.data()[seed] == kFree) grow_from(seed);
    }
    return std::move(growth_);
  }

 private:
  void grow_from(size_t seed) {
    begin(seed);
    while (area_ < limits_.max_area_px) {
      if (!waiting_.empty()) {
        const uint32_t pick = random_.below(static_cast<uint32_t>(waiting_.size()));
        const size_t at = waiting_[pick];
        waiting_[pick] = waiting_.back();
        waiting_.pop_back();
        if (admissible(variation_.data()[at]))
          add(at);
        else
          refuse(at);
      } else if (const auto at = take_back()) {
        add(*at);
      } else {
        break;
      }
    }
    close();
  }

  void begin(size_t seed) {
    fragment_ = static_cast<uint32_t>(growth_.seeds.size());
    growth_.seeds.push_back(seed);
    class_ = index_.data()[seed];
    area_ = 0;
    sum_ = 0;
    box_ = {};
    bordering_.clear();
    asked_by_[seed] = fragment_;
    add(seed);
  }

  bool admissible(float v) const {
    return std::fabs(static_cast<double>(v) - sum_ / area_) < static_cast<double>(limits_.threshold);
  }

  /// Joins the texel, unless the box would become too large, and asks its free neighbors.
  void add(size_t at) {
    const TorusBox box = joined(box_, texel_of(at, size_), size_);
    if (!fits(box, limits_.max_extent)) return;
    box_ = box;
    growth_.idx.data()[at] = fragment_;
    ++area_;
    sum_ += static_cast<double>(variation_.data()[at]);
    for (const size_t n : Neighbors(at, size_).at) {
      if (growth_.idx.data()[n] != kFree || asked_by_[n] == fragment_) continue;
      asked_by_[n] = fragment_;
      bordering_.push_back(n);
      if (index_.data()[n] == class_) waiting_.push_back(n);
    }
  }

  void refuse(size_t at) {
    const float v = variation_.data()[at];
    if (v > sum_ / area_)
      above_.push({v, at});
    else
      below_.push({v, at});
  }

  /// The refused texel nearest to the mean, if the mean has come near enough to it.
  std::optional<size_t> take_back() {
    // Those that the mean has passed change sides, so that the two tops are the nearest ones.
    const double mean = sum_ / area_;
    for (; !above_.empty() && above_.top().v < mean; above_.pop()) below_.push(above_.top());
    for (; !below_.empty() && below_.top().v > mean; below_.pop()) above_.push(below_.top());
    const double up = above_.empty() ? HUGE_VAL : static_cast<double>(above_.top().v) - mean;
    const double down = below_.empty() ? HUGE_VAL : mean - static_cast<double>(below_.top().v);
    if (!(std::min(up, down) < static_cast<double>(limits_.threshold))) return std::nullopt;

    const bool from_above = up != down ? up < down : above_.top().at < below_.top().at;
    const size_t at = from_above ? above_.top().at : below_.top().at;
    if (from_above)
      above_.pop();
    else
      below_.pop();
    return at;
  }

  /// What it has asked and not taken borders it: the next seeds.
  void close() {
    for (const size_t at : bordering_)
      if (growth_.idx.data()[at] == kFree && !in_frontier_[at]) {
        in_frontier_[at] = 1;
        frontier_.push_back(at);
      }
    waiting_.clear();
    above_ = {};
    below_ = {};
  }

  const Image<uint8_t>& index_;
  const Image<float>& variation_;
  const GrowthLimits limits_;
  const V2i size_;
  Random random_;
  Growth growth_;
  std::vector<uint32_t> asked_by_;    // the last fragment that asked this texel
  std::vector<uint8_t> in_frontier_;  // has been pushed to frontier_
  std::vector<size_t> frontier_;      // texels bordering the fragments made so far; those taken since are skipped

  uint32_t fragment_ = 0;  // the fragment that grows now
  uint8_t class_ = 0;
  int area_ = 0;
  double sum_ = 0;  // of v
  TorusBox box_;
  std::vector<size_t> bordering_;  // all that were asked
  std::vector<size_t> waiting_;    // of its class, asked and not yet answered
  std::priority_queue<Refused, std::vector<Refused>, LowestFirst> above_;
  std::priority_queue<Refused, std::vector<Refused>, HighestFirst> below_;
};

}  // namespace

Growth grow(const Image<uint8_t>& index, const Image<float>& variation, const GrowthLimits& limits) {
  return Grower(index, variation, limits).run();
}

}  // namespace texbake
