// What `texbake verify` asks of a partition that was read from a file.
#include <algorithm>
#include <optional>

#include "libbake/segment/partition.h"

namespace texbake {
namespace {

using Kind = PartitionFault::Kind;

/// What one pass over the texels finds out about one shape.
struct Facts {
  int64_t area = 0, sum_x = 0, sum_y = 0;
  V2i first{0, 0}, low{0, 0}, high{0, 0};
  std::optional<PartitionFault> not_connected, inconsistent_owner;
};

class Checker {
 public:
  explicit Checker(const Partition& partition)
      : partition_(partition), size_(partition.size()), facts_(partition.centers.size()) {}

  std::vector<PartitionFault> faults() {
    for (int y = 0; y < size_.y; ++y)
      for (int x = 0; x < size_.x; ++x) visit({x, y});
    find_pieces();
    for (uint32_t shape = 0; shape < facts_.size(); ++shape) judge(shape);
    return std::move(faults_);
  }

 private:
  bool in_range(uint32_t shape) const { return shape < facts_.size(); }

  static void count(std::optional<PartitionFault>& fault, Kind kind, uint32_t shape, V2i texel) {
    if (fault)
      ++fault->count;
    else
      fault = PartitionFault{kind, shape, texel, 1};
  }

  /// Range of idx and owner, agreement with the right and the lower neighbor, and the sums for the center.
  void visit(V2i p) {
    const uint32_t shape = partition_.idx(p.x, p.y);
    if (!in_range(shape)) {
      if (faults_.empty())
        faults_.push_back({Kind::idx_out_of_range, shape, p, 1});
      else
        ++faults_.front().count;
      return;
    }
    Facts& facts = facts_[shape];
    const OwnerOffset owner = partition_.owner(p.x, p.y);
    const V2i u = partition_.unwrapped(p.x, p.y);
    bool consistent = std::abs(owner.x) <= 1 && std::abs(owner.y) <= 1;
    for (int n = 0; n < 2; ++n) {
      const V2i q = wrap(V2i(p.x + kNeighborX[n], p.y + kNeighborY[n]), size_);
      if (partition_.idx(q.x, q.y) == shape)
        consistent = consistent && partition_.unwrapped(q.x, q.y) == V2i(u.x + kNeighborX[n], u.y + kNeighborY[n]);
    }
    if (!consistent) count(facts.inconsistent_owner, Kind::inconsistent_owner, shape, p);
    if (facts.area == 0) {
      facts.first = p;
      facts.low = facts.high = u;
    }
    facts.low = {std::min(facts.low.x, u.x), std::min(facts.low.y, u.y)};
    facts.high = {std::max(facts.high.x, u.x), std::max(facts.high.y, u.y)};
    facts.sum_x += u.x;
    facts.sum_y += u.y;
    ++facts.area;
  }

  /// Floods from the first texel of each shape; what is left of a shape after that is not connected to it.
  void find_pieces() {
    Image<uint8_t> visited(size_.x, size_.y);
    std::vector<V2i> stack;
    for (int y = 0; y < size_.y; ++y)
      for (int x = 0; x < size_.x; ++x) {
        const uint32_t shape = partition_.idx(x, y);
        if (visited(x, y) || !in_range(shape)) continue;
        if (facts_[shape].first != V2i(x, y)) {
          count(facts_[shape].not_connected, Kind::not_connected, shape, {x, y});
          continue;
        }
        visited(x, y) = 1;
        for (stack.assign(1, {x, y}); !stack.empty();) {
          const V2i p = stack.back();
          stack.pop_back();
          for (int n = 0; n < 4; ++n) {
            const V2i q = wrap(V2i(p.x + kNeighborX[n], p.y + kNeighborY[n]), size_);
            if (visited(q.x, q.y) || partition_.idx(q.x, q.y) != shape) continue;
            visited(q.x, q.y) = 1;
            stack.push_back(q);
          }
        }
      }
  }

  void judge(uint32_t shape) {
    const Facts& facts = facts_[shape];
    if (facts.area == 0) {
      faults_.push_back({Kind::empty_shape, shape, {0, 0}, 1});
      return;
    }
    if (facts.not_connected) faults_.push_back(*facts.not_connected);
    if (facts.inconsistent_owner) faults_.push_back(*facts.inconsistent_owner);
    if (facts.high.x - facts.low.x >= max_extent(size_.x) || facts.high.y - facts.low.y >= max_extent(size_.y))
      faults_.push_back({Kind::too_large, shape, facts.first, 1});
    const V2i center = partition_.centers[shape];
    if (rounded_mean(facts.sum_x, facts.area) != center.x || rounded_mean(facts.sum_y, facts.area) != center.y ||
        wrap(center, size_) != center)
      faults_.push_back({Kind::wrong_center, shape, facts.first, 1});
    if (partition_.areas_px[shape] != static_cast<uint64_t>(facts.area))
      faults_.push_back({Kind::wrong_area, shape, facts.first, 1});
  }

  const Partition& partition_;
  V2i size_;
  std::vector<Facts> facts_;
  std::vector<PartitionFault> faults_;
};

}  // namespace

std::vector<PartitionFault> check_partition(const Partition& partition) { return Checker(partition).faults(); }

}  // namespace texbake
