#include "libbake/segment/clean.h"

#include <algorithm>
#include <queue>

#include "libbake/segment/neighbors.h"
#include "libbake/segment/torus_box.h"

namespace texbake {
namespace {

/// A fragment as cleaning sees it.
struct Body {
  size_t seed = 0;
  int area = 0;
  double sum[3] = {0, 0, 0};  // of the colors
  TorusBox box;
  bool is_stuck = false;  // no neighbor can take what it holds
};

/// A fragment that may be too small, with its area when it was queued.
struct Candidate {
  int area;
  uint32_t fragment;
  bool operator>(const Candidate& b) const { return area != b.area ? area > b.area : fragment > b.fragment; }
};

class Cleaner {
 public:
  Cleaner(Growth growth, const Image<V3f>& luv, const CleaningLimits& limits)
      : growth_(std::move(growth)), luv_(luv), limits_(limits), size_(luv.width(), luv.height()) {
    for (const size_t seed : growth_.seeds) bodies_.push_back({.seed = seed, .box = {}});
    for (size_t at = 0; at < growth_.idx.size(); ++at) account(growth_.idx.data()[at], at);
  }

  Growth run() {
    for (uint32_t fragment = 0; fragment < bodies_.size(); ++fragment) enqueue(fragment);
    while (!queue_.empty()) {
      const Candidate smallest = queue_.top();
      queue_.pop();
      const Body& body = bodies_[smallest.fragment];
      if (body.area == 0 || body.is_stuck) continue;
      if (body.area != smallest.area)
        enqueue(smallest.fragment);
      else
        empty(smallest.fragment);
    }
    return numbered_by_rows();
  }

 private:
  void account(uint32_t fragment, size_t at) {
    Body& body = bodies_[fragment];
    const V3f& color = luv_.data()[at];
    ++body.area;
    for (int c = 0; c < 3; ++c) body.sum[c] += static_cast<double>(color[c]);
    body.box = joined(body.box, texel_of(at, size_), size_);
  }

  void enqueue(uint32_t fragment) {
    const int area = bodies_[fragment].area;
    if (area < limits_.min_area_px) queue_.push({area, fragment});
  }

  /// Frees the texels of the fragment; returns them in breadth-first order from its seed.
  std::vector<size_t> texels_of(uint32_t fragment) {
    std::vector<size_t> texels{bodies_[fragment].seed};
    growth_.idx.data()[texels[0]] = kFree;
    for (size_t head = 0; head < texels.size(); ++head)
      for (const size_t n : Neighbors(texels[head], size_).at)
        if (growth_.idx.data()[n] == fragment) {
          growth_.idx.data()[n] = kFree;
          texels.push_back(n);
        }
    return texels;
  }

  void empty(uint32_t fragment) {
    std::vector<size_t> texels = texels_of(fragment);
    std::sort(texels.begin(), texels.end());
    bodies_[fragment].area = 0;

    // From the border inward: first those that touch another fragment, then those that touch the first.
    std::vector<size_t> wave;
    for (const size_t at : texels)
      for (const size_t n : Neighbors(at, size_).at)
        if (growth_.idx.data()[n] != kFree) {
          wave.push_back(at);
          break;
        }
    for (size_t head = 0; head < wave.size(); ++head) {
      const size_t at = wave[head];
      if (growth_.idx.data()[at] != kFree) continue;
      const uint32_t target = nearest_neighbor(at);
      if (target == kFree) continue;
      growth_.idx.data()[at] = target;
      account(target, at);
      for (const size_t n : Neighbors(at, size_).at)
        if (growth_.idx.data()[n] == kFree) wave.push_back(n);
    }
    for (const size_t at : texels)
      if (growth_.idx.data()[at] == kFree) keep_piece(at);
  }

  /// The neighboring fragment of nearest mean color that may take the texel; kFree when none may.
  uint32_t nearest_neighbor(size_t at) const {
    uint32_t best = kFree;
    bool best_is_full = true;
    double best_distance = 0;
    for (const size_t n : Neighbors(at, size_).at) {
      const uint32_t fragment = growth_.idx.data()[n];
      if (fragment == kFree) continue;
      const Body& body = bodies_[fragment];
      if (!fits(joined(body.box, texel_of(at, size_), size_), limits_.max_extent)) continue;
      const bool is_full = body.area >= limits_.max_area_px;
      const double distance = squared_distance(luv_.data()[at], body);
      const bool is_better = best == kFree || (is_full != best_is_full ? best_is_full : distance < best_distance) ||
                             (is_full == best_is_full && distance == best_distance && fragment < best);
      if (!is_better) continue;
      best = fragment;
      best_is_full = is_full;
      best_distance = distance;
    }
    return best;
  }

  static double squared_distance(const V3f& color, const Body& body) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
      const double d = static_cast<double>(color[c]) - body.sum[c] / body.area;
      sum += d * d;
    }
    return sum;
  }

  /// What no neighbor could take becomes a fragment that stays, however small.
  void keep_piece(size_t seed) {
    const auto fragment = static_cast<uint32_t>(bodies_.size());
    bodies_.push_back({.seed = seed, .box = {}, .is_stuck = true});
    std::vector<size_t> piece{seed};
    growth_.idx.data()[seed] = fragment;
    for (size_t head = 0; head < piece.size(); ++head) {
      account(fragment, piece[head]);
      for (const size_t n : Neighbors(piece[head], size_).at)
        if (growth_.idx.data()[n] == kFree) {
          growth_.idx.data()[n] = fragment;
          piece.push_back(n);
        }
    }
  }

  Growth numbered_by_rows() {
    Growth result;
    std::vector<uint32_t> number(bodies_.size(), kFree);
    for (uint32_t& fragment : growth_.idx) {
      if (number[fragment] == kFree) {
        number[fragment] = static_cast<uint32_t>(result.count());
        result.seeds.push_back(bodies_[fragment].seed);
      }
      fragment = number[fragment];
    }
    result.idx = std::move(growth_.idx);
    return result;
  }

  Growth growth_;
  const Image<V3f>& luv_;
  const CleaningLimits limits_;
  const V2i size_;
  std::vector<Body> bodies_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

Growth clean(Growth growth, const Image<V3f>& luv, const CleaningLimits& limits) {
  return Cleaner(std::move(growth), luv, limits).run();
}

}  // namespace texbake
