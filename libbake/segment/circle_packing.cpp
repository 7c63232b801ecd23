#include "libbake/segment/circle_packing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libbake/base/parallel.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

constexpr int kThrows = 8;       // for each center
constexpr int kPushes = 24;      // enough to even out the gaps, too few to end in a honeycomb
constexpr double kReach = 1.15;  // cells; neighbors in the densest packing are 2^½ / 3^¼ = 1.07 apart
constexpr double kPush = 0.25;   // share of the overlap that each of the two gives way
constexpr int kBalanceSteps = 60;
constexpr double kBalanceRate = 0.3;  // cells² per share of a cell too much or too little
constexpr size_t kNearest = 12;       // circles that may ever take a point

double shortest_step(double d, double n) { return d - n * std::floor(d / n + 0.5); }

double nearest_squared(const CirclePacking& packing, V2d point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < packing.centers.size(); ++i) nearest = std::min(nearest, packing.squared_distance(point, i));
  return nearest;
}

V2d random_point(V2i size, Random& random) {
  const double x = static_cast<double>(random.uniform()) * size.x;
  const double y = static_cast<double>(random.uniform()) * size.y;
  return {x, y};
}

/// Every pair of overlapping circles gives way; the one over the corner stays.
void push_apart(CirclePacking& packing) {
  const std::vector<V2d> before = packing.centers;
  parallel_for(1, static_cast<int>(before.size()), [&](int i) {
    V2d& center = packing.centers[static_cast<size_t>(i)];
    V2d push(0, 0);
    for (size_t j = 0; j < before.size(); ++j) {
      const V2d d(shortest_step(before[static_cast<size_t>(i)].x - before[j].x, packing.size.x) / packing.cell.x,
                  shortest_step(before[static_cast<size_t>(i)].y - before[j].y, packing.size.y) / packing.cell.y);
      const double distance = std::sqrt(d.x * d.x + d.y * d.y);
      if (distance == 0 || distance >= kReach) continue;
      const double give = kPush * (kReach - distance) / distance;
      push = {push.x + give * d.x, push.y + give * d.y};
    }
    const double x = center.x + push.x * packing.cell.x, y = center.y + push.y * packing.cell.y;
    center = {x - packing.size.x * std::floor(x / packing.size.x), y - packing.size.y * std::floor(y / packing.size.y)};
  });
}

/// The nearest circles of each point, nearest first, `kNearest` or all.
std::vector<uint32_t> nearest_circles(const CirclePacking& packing, const std::vector<V2d>& points) {
  const size_t keep = std::min(kNearest, packing.centers.size());
  std::vector<uint32_t> nearest(points.size() * keep);
  parallel_for(
      0, static_cast<int>(points.size()),
      [&](int p) {
        std::vector<std::pair<double, uint32_t>> all;
        for (size_t i = 0; i < packing.centers.size(); ++i)
          all.emplace_back(packing.squared_distance(points[static_cast<size_t>(p)], i), static_cast<uint32_t>(i));
        std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(keep), all.end());
        for (size_t k = 0; k < keep; ++k) nearest[static_cast<size_t>(p) * keep + k] = all[k].second;
      },
      64);
  return nearest;
}

}  // namespace

double CirclePacking::squared_distance(V2d point, size_t i) const {
  const double x = shortest_step(point.x - centers[i].x, size.x) / cell.x;
  const double y = shortest_step(point.y - centers[i].y, size.y) / cell.y;
  return x * x + y * y;
}

V2d packing_cell(V2i size, int count) {
  const double width = size.x, height = size.y;
  const double widest = std::max(1.0 / 3, 1 / std::sqrt(static_cast<double>(count)));  // of the tile
  double share_x = std::sqrt(height / (width * count)), share_y = std::sqrt(width / (height * count));
  if (share_x > widest) {
    share_x = widest;
    share_y = 1 / (count * share_x);
  } else if (share_y > widest) {
    share_y = widest;
    share_x = 1 / (count * share_y);
  }
  return {share_x * width, share_y * height};
}

CirclePacking pack_circles(V2i size, int count, uint32_t seed, uint32_t stream) {
  CirclePacking packing{size, packing_cell(size, count), {V2d(0, 0)}, {}};
  Random random(seed, stream);
  while (static_cast<int>(packing.centers.size()) < count) {
    V2d best(0, 0);
    double farthest = -1;
    for (int i = 0; i < kThrows; ++i) {
      const V2d point = random_point(size, random);
      const double distance = nearest_squared(packing, point);
      if (distance <= farthest) continue;
      farthest = distance;
      best = point;
    }
    packing.centers.push_back(best);
  }
  for (int i = 0; i < kPushes; ++i) push_apart(packing);
  packing.power.assign(packing.centers.size(), 0.0);
  return packing;
}

CirclePacking balance(CirclePacking packing, const std::vector<V2d>& points, const std::vector<uint32_t>& weights) {
  const std::vector<uint32_t> nearest = nearest_circles(packing, points);
  const size_t keep = points.empty() ? 0 : nearest.size() / points.size();
  std::vector<double> distances(nearest.size());
  double total = 0;
  for (size_t p = 0; p < points.size(); ++p) {
    total += weights[p];
    for (size_t k = 0; k < keep; ++k)
      distances[p * keep + k] = packing.squared_distance(points[p], nearest[p * keep + k]);
  }

  const double fair = total / static_cast<double>(packing.centers.size());
  for (int step = 0; step < kBalanceSteps; ++step) {
    std::vector<double> taken(packing.centers.size(), 0.0);
    for (size_t p = 0; p < points.size(); ++p) {
      uint32_t best = 0;
      double least = std::numeric_limits<double>::infinity();
      for (size_t at = p * keep; at < (p + 1) * keep; ++at) {
        const double power_distance = distances[at] - packing.power[nearest[at]];
        if (power_distance < least || (power_distance == least && nearest[at] < best)) {
          least = power_distance;
          best = nearest[at];
        }
      }
      taken[best] += weights[p];
    }
    // Smaller and smaller steps, so that points with much weight do not go back and forth.
    const double rate = kBalanceRate * (kBalanceSteps - step) / kBalanceSteps;
    for (size_t i = 0; i < taken.size(); ++i) packing.power[i] += rate * (1 - taken[i] / fair);
  }
  return packing;
}

}  // namespace texbake
