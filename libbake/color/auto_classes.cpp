#include "libbake/color/auto_classes.h"

#include <algorithm>
#include <map>

#include "libbake/base/parallel.h"
#include "libbake/color/octree.h"

namespace texbake {
namespace {

// From grouping by hue to grouping by lightness.
constexpr float kLightnessScales[] = {0.125f, 0.25f, 0.5f, 1, 2, 4};
constexpr int kStarts = static_cast<int>(std::size(kLightnessScales));

// Starts are compared before they have fully settled: their order seldom changes afterwards.
constexpr int kStartIterations = 40;
constexpr double kStartGain = 1e-3;

constexpr int kFewestClasses = 3, kMostClasses = 8;
// Cost with one class more / cost. Measured on fourteen photographs: while classes separate hues it is 0.26 … 0.82,
// beyond that 0.84 … 0.95.
constexpr double kPayingRatio = 0.83;
// Mean squared; 1.2 ΔE is about what one can tell from a uniform surface.
constexpr double kVisibleCost = 1.2 * 1.2;

int count_distinct(const PointSet& points, size_t enough) {
  std::vector<PointF> found;
  for (int i = 0; i < points.size() && found.size() < enough; ++i)
    if (const PointF point = points.point(i); std::find(found.begin(), found.end(), point) == found.end())
      found.push_back(point);
  return static_cast<int>(found.size());
}

}  // namespace

LineKMeansResult best_lines(const PointSet& points, int classes, float along_weight) {
  std::array<LineKMeansResult, kStarts> results;
  parallel_for(0, kStarts, [&](int i) {
    const std::vector<PointF> starts = octree_quantize(points, classes, kLightnessScales[i]);
    results[static_cast<size_t>(i)] = line_kmeans(
        points, starts, {.along_weight = along_weight, .max_iterations = kStartIterations, .least_gain = kStartGain});
  });
  return std::move(*std::min_element(results.begin(), results.end(),
                                     [](const auto& a, const auto& b) { return a.costs.back() < b.costs.back(); }));
}

LineKMeansResult best_lines_of_auto_count(const PointSet& points, float along_weight) {
  const int distinct = count_distinct(points, kMostClasses);
  std::map<int, LineKMeansResult> best;
  const auto result = [&](int classes) -> LineKMeansResult& {
    if (!best.contains(classes)) best[classes] = best_lines(points, classes, along_weight);
    return best[classes];
  };
  const auto pays = [&](int classes) {
    const double cost = result(classes).costs.back();
    if (cost < kVisibleCost) return false;
    return result(classes + 1).costs.back() < kPayingRatio * cost ||
           result(classes + 2).costs.back() < kPayingRatio * kPayingRatio * cost;
  };
  int classes = std::min(kFewestClasses, distinct);
  while (classes < std::min(kMostClasses, distinct) && pays(classes)) ++classes;
  return std::move(result(classes));
}

}  // namespace texbake
