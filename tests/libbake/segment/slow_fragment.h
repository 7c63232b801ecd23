// Growth and cleaning in the most obvious way: every choice by looking at every texel. The oracle of grow.h and
// clean.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "libbake/base/random.h"
#include "libbake/segment/clean.h"

namespace texbake::slow {

inline constexpr uint32_t kNone = 0xffffffffu;

/// Columns (rows) of the shortest arc of a circle that holds every marked place: the circle without its longest gap.
inline int arc(const std::set<int>& marked, int n) {
  int longest_gap = 0;
  for (const int begin : marked) {
    int gap = 0;
    while (gap < n && !marked.contains((begin + 1 + gap) % n)) ++gap;
    longest_gap = std::max(longest_gap, std::min(gap, n - 1));
  }
  return n - longest_gap;
}

inline std::vector<V2i> texels_of(const Image<uint32_t>& idx, uint32_t shape) {
  std::vector<V2i> texels;
  for (int y = 0; y < idx.height(); ++y)
    for (int x = 0; x < idx.width(); ++x)
      if (idx(x, y) == shape) texels.push_back({x, y});
  return texels;
}

inline bool fits(const Image<uint32_t>& idx, uint32_t shape, V2i also, V2i limit) {
  std::set<int> columns{also.x}, rows{also.y};
  for (const V2i& p : texels_of(idx, shape)) {
    columns.insert(p.x);
    rows.insert(p.y);
  }
  return arc(columns, idx.width()) <= limit.x && arc(rows, idx.height()) <= limit.y;
}

inline std::vector<V2i> neighbors(const Image<uint32_t>& idx, V2i p) {
  std::vector<V2i> result;
  for (int n = 0; n < 4; ++n)
    result.push_back(wrap(V2i(p.x + kNeighborX[n], p.y + kNeighborY[n]), V2i(idx.width(), idx.height())));
  return result;
}

inline bool contains(const std::vector<V2i>& texels, V2i p) {
  return std::find(texels.begin(), texels.end(), p) != texels.end();
}

inline double mean_of(const Image<float>& v, const std::vector<V2i>& texels) {
  double sum = 0;
  for (const V2i& p : texels) sum += static_cast<double>(v(p.x, p.y));
  return sum / static_cast<double>(texels.size());
}

inline Growth grow(const Image<uint8_t>& index, const Image<float>& v, const GrowthLimits& limits) {
  const int width = index.width();
  Growth growth;
  growth.idx = Image<uint32_t>(width, index.height(), kNone);
  Random random(limits.seed);
  std::vector<V2i> frontier;
  std::vector<V2i> ever_in_frontier;
  auto at = static_cast<int>(random.below(static_cast<uint32_t>(index.size())));
  V2i seed(at % width, at / width);
  for (;;) {
    const auto fragment = static_cast<uint32_t>(growth.count());
    growth.seeds.push_back(static_cast<size_t>(seed.y * width + seed.x));
    std::vector<V2i> asked{seed}, refused;
    std::vector<V2i> members;
    std::vector<V2i> waiting{seed};  // of those asked, in no order that matters but the same as in grow.cpp
    const auto mean = [&] { return mean_of(v, members); };
    while (static_cast<int>(members.size()) < limits.max_area_px) {
      V2i p;
      if (!waiting.empty()) {
        // The seed is not picked by chance.
        const uint32_t pick = members.empty() ? 0 : random.below(static_cast<uint32_t>(waiting.size()));
        p = waiting[pick];
        waiting[pick] = waiting.back();
        waiting.pop_back();
        const bool is_free = growth.idx(p.x, p.y) == kNone, is_seed = members.empty();
        if (!is_free) continue;
        if (!is_seed && std::fabs(static_cast<double>(v(p.x, p.y)) - mean()) >= static_cast<double>(limits.threshold)) {
          refused.push_back(p);
          continue;
        }
      } else {
        const auto less = [&](V2i a, V2i b) {
          const double da = std::fabs(static_cast<double>(v(a.x, a.y)) - mean());
          const double db = std::fabs(static_cast<double>(v(b.x, b.y)) - mean());
          return da != db ? da < db : a.y != b.y ? a.y < b.y : a.x < b.x;
        };
        const auto nearest = std::min_element(refused.begin(), refused.end(), less);
        if (nearest == refused.end()) break;
        p = *nearest;
        if (std::fabs(static_cast<double>(v(p.x, p.y)) - mean()) >= static_cast<double>(limits.threshold)) break;
        refused.erase(nearest);
      }
      if (!fits(growth.idx, fragment, p, limits.max_extent)) continue;
      growth.idx(p.x, p.y) = fragment;
      members.push_back(p);
      for (const V2i& q : neighbors(growth.idx, p))
        if (growth.idx(q.x, q.y) == kNone && !contains(asked, q)) {
          asked.push_back(q);
          if (index(q.x, q.y) == index(seed.x, seed.y)) waiting.push_back(q);
        }
    }
    for (const V2i& p : asked)
      if (growth.idx(p.x, p.y) == kNone && !contains(ever_in_frontier, p)) {
        frontier.push_back(p);
        ever_in_frontier.push_back(p);
      }
    do {
      if (frontier.empty()) return growth;
      const uint32_t pick = random.below(static_cast<uint32_t>(frontier.size()));
      seed = frontier[pick];
      frontier[pick] = frontier.back();
      frontier.pop_back();
    } while (growth.idx(seed.x, seed.y) != kNone);
  }
}

/// Squared distance of a color from the mean color of a shape.
inline double squared_distance(const Image<uint32_t>& idx, uint32_t shape, const Image<V3f>& luv, V2i p) {
  const auto texels = texels_of(idx, shape);
  double distance = 0;
  for (int c = 0; c < 3; ++c) {
    double sum = 0;
    for (const V2i& q : texels) sum += static_cast<double>(luv(q.x, q.y)[c]);
    const double d = static_cast<double>(luv(p.x, p.y)[c]) - sum / static_cast<double>(texels.size());
    distance += d * d;
  }
  return distance;
}

/// Only the partition: shapes numbered by their first texel in row order.
inline Image<uint32_t> clean(const Growth& growth, const Image<V3f>& luv, const CleaningLimits& limits) {
  Image<uint32_t> idx = growth.idx.clone();
  auto count = static_cast<uint32_t>(growth.count());
  std::set<uint32_t> stuck;
  for (;;) {
    // The smallest fragment that is too small, the lowest index among equals.
    uint32_t smallest = kNone;
    size_t least = static_cast<size_t>(limits.min_area_px);
    for (uint32_t f = 0; f < count; ++f) {
      const size_t area = texels_of(idx, f).size();
      if (area == 0 || area >= least || stuck.contains(f)) continue;
      smallest = f;
      least = area;
    }
    if (smallest == kNone) break;

    const auto emptied = texels_of(idx, smallest);
    for (const V2i& p : emptied) idx(p.x, p.y) = kNone;
    std::vector<V2i> queue;
    for (const V2i& p : emptied)
      for (const V2i& q : neighbors(idx, p))
        if (idx(q.x, q.y) != kNone && !contains(queue, p)) queue.push_back(p);
    for (size_t head = 0; head < queue.size(); ++head) {
      const V2i p = queue[head];
      if (idx(p.x, p.y) != kNone) continue;
      uint32_t best = kNone;
      for (const bool may_be_full : {false, true}) {
        double nearest = 0;
        for (const V2i& q : neighbors(idx, p)) {
          const uint32_t f = idx(q.x, q.y);
          if (f == kNone || best == f || !fits(idx, f, p, limits.max_extent)) continue;
          if (!may_be_full && texels_of(idx, f).size() >= static_cast<size_t>(limits.max_area_px)) continue;
          const double distance = squared_distance(idx, f, luv, p);
          if (best == kNone || distance < nearest || (distance == nearest && f < best)) {
            best = f;
            nearest = distance;
          }
        }
        if (best != kNone) break;
      }
      if (best == kNone) continue;
      idx(p.x, p.y) = best;
      for (const V2i& q : neighbors(idx, p))
        if (idx(q.x, q.y) == kNone) queue.push_back(q);
    }

    // What found no place stays, piece by piece.
    for (const V2i& p : emptied) {
      if (idx(p.x, p.y) != kNone) continue;
      stuck.insert(count);
      std::vector<V2i> piece{p};
      idx(p.x, p.y) = count;
      for (size_t head = 0; head < piece.size(); ++head)
        for (const V2i& q : neighbors(idx, piece[head]))
          if (idx(q.x, q.y) == kNone) {
            idx(q.x, q.y) = count;
            piece.push_back(q);
          }
      ++count;
    }
  }
  std::vector<uint32_t> order;
  for (uint32_t& f : idx) {
    auto found = std::find(order.begin(), order.end(), f);
    if (found == order.end()) found = order.insert(order.end(), f);
    f = static_cast<uint32_t>(found - order.begin());
  }
  return idx;
}

}  // namespace texbake::slow
