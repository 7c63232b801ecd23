#include "libbake/color/line_kmeans.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr int kBlock = 4096;      // points whose moments are summed by one task
constexpr int kLane = 512;        // points whose running minima stay in the first cache level
constexpr float kNoCost = 1e-6f;  // (0.001 ΔE)²: the point lies on its class

// r² + w t² with D known when compiled, so that loops over points unroll the coordinates and vectorize.
template <int D>
float cost(const float* const (&coordinates)[4], int i, const ColorLine& line, float keep) {
  float squared = 0, along = 0;
  for (size_t c = 0; c < D; ++c) {
    const float difference = coordinates[c][i] - line.point[c];
    squared += difference * difference;
    along += difference * line.direction[c];
  }
  return squared - keep * (along * along);
}

// Running minima over the lines, for up to kLane points. The choice is made with masks: a branch would not vectorize.
template <int D>
void assign_lane(const float* const (&coordinates)[4], int count, std::span<const ColorLine> lines, float along_weight,
                 uint8_t* labels) {
  float least[kLane];
  int32_t nearest[kLane];
  const float keep = 1 - along_weight;
  for (int i = 0; i < count; ++i) {
    least[i] = cost<D>(coordinates, i, lines[0], keep);
    nearest[i] = 0;
  }
  for (size_t k = 1; k < lines.size(); ++k) {
    const ColorLine line = lines[k];
    const auto label = static_cast<int32_t>(k);
    for (int i = 0; i < count; ++i) {
      const float candidate = cost<D>(coordinates, i, line, keep);
      const int32_t closer = -static_cast<int32_t>(candidate < least[i]);
      nearest[i] = (label & closer) | (nearest[i] & ~closer);
      least[i] = candidate < least[i] ? candidate : least[i];
    }
  }
  for (int i = 0; i < count; ++i) labels[i] = static_cast<uint8_t>(nearest[i]);
}

template <int D>
void add_block(const PointSet& points, const std::vector<uint8_t>& labels, int block, std::vector<Moments>& moments) {
  const std::array<const float*, 4> coordinates = points.data();
  for (int i = block * kBlock; i < std::min(points.size(), (block + 1) * kBlock); ++i) {
    PointD point{};
    for (size_t c = 0; c < D; ++c) point[c] = coordinates[c][i];
    moments[labels[static_cast<size_t>(i)]].add<D>(point);
  }
}

// The moments of every class, summed block by block in the order of the points.
std::vector<Moments> class_moments(const PointSet& points, const std::vector<uint8_t>& labels, size_t classes) {
  const int blocks = (points.size() + kBlock - 1) / kBlock;
  std::vector<std::vector<Moments>> partial(static_cast<size_t>(blocks), std::vector<Moments>(classes));
  parallel_for(0, blocks, [&](int block) {
    const auto add = points.dimension == 3 ? add_block<3> : add_block<4>;
    add(points, labels, block, partial[static_cast<size_t>(block)]);
  });
  std::vector<Moments> moments(classes);
  for (const auto& block : partial)
    for (size_t k = 0; k < classes; ++k) moments[k].add(block[k]);
  return moments;
}

std::vector<uint8_t> assign(const PointSet& points, std::span<const ColorLine> lines, float along_weight) {
  std::vector<uint8_t> labels(static_cast<size_t>(points.size()));
  parallel_for(0, (points.size() + kBlock - 1) / kBlock, [&](int block) {
    const int begin = block * kBlock;
    assign_to_lines(points.data(begin), points.dimension, std::min(kBlock, points.size() - begin), lines, along_weight,
                    labels.data() + begin);
  });
  return labels;
}

// Gives every empty class the point of greatest cost, while there is one that costs anything.
void fill_empty_classes(const PointSet& points, std::span<const ColorLine> lines, float along_weight,
                        std::vector<uint8_t>& labels) {
  std::vector<int> sizes(lines.size());
  for (const uint8_t label : labels) ++sizes[label];
  if (std::find(sizes.begin(), sizes.end(), 0) == sizes.end()) return;

  std::vector<float> costs(labels.size());
  for (size_t i = 0; i < labels.size(); ++i)
    costs[i] = line_cost(points.point(static_cast<int>(i)), lines[labels[i]], along_weight);
  for (size_t k = 0; k < lines.size(); ++k) {
    if (sizes[k] > 0) continue;
    const auto worst = std::max_element(costs.begin(), costs.end());
    if (*worst <= kNoCost) return;
    const auto i = static_cast<size_t>(worst - costs.begin());
    if (sizes[labels[i]] == 1) return;
    --sizes[labels[i]];
    labels[i] = static_cast<uint8_t>(k);
    sizes[k] = 1;
    *worst = 0;
  }
}

struct Fit {
  std::vector<ColorLine> lines;
  double cost = 0, squared_error = 0;  // sums over points
};

// Mean and principal axis of every class; an empty class keeps its line.
Fit fit_lines(const std::vector<Moments>& moments, const std::vector<ColorLine>& before, int dimension,
              float along_weight) {
  Fit fit{.lines = before, .cost = 0, .squared_error = 0};
  for (size_t k = 0; k < moments.size(); ++k) {
    if (moments[k].count == 0) continue;
    const PointD mean = moments[k].mean();
    const PrincipalAxis axis = principal_axis(moments[k].covariance(), dimension);
    for (size_t c = 0; c < mean.size(); ++c) {
      fit.lines[k].point[c] = static_cast<float>(mean[c]);
      fit.lines[k].direction[c] = static_cast<float>(axis.direction[c]);
    }
    fit.squared_error += moments[k].count * (axis.total - axis.variance);
    fit.cost += moments[k].count * (axis.total - (1 - static_cast<double>(along_weight)) * axis.variance);
  }
  return fit;
}

}  // namespace

void assign_to_lines(const std::array<const float*, 4>& coordinates, int dimension, int count,
                     std::span<const ColorLine> lines, float along_weight, uint8_t* labels) {
  for (int begin = 0; begin < count; begin += kLane) {
    const float* lane[4] = {};
    for (size_t c = 0; c < static_cast<size_t>(dimension); ++c) lane[c] = coordinates[c] + begin;
    const int size = std::min(kLane, count - begin);
    if (dimension == 3)
      assign_lane<3>(lane, size, lines, along_weight, labels + begin);
    else
      assign_lane<4>(lane, size, lines, along_weight, labels + begin);
  }
}

float line_cost(const PointF& point, const ColorLine& line, float along_weight) {
  float squared = 0, along = 0;
  for (size_t c = 0; c < point.size(); ++c) {
    const float difference = point[c] - line.point[c];
    squared += difference * difference;
    along += difference * line.direction[c];
  }
  return squared - (1 - along_weight) * (along * along);
}

LineKMeansResult line_kmeans(const PointSet& points, std::span<const PointF> starts, const LineKMeansOptions& options) {
  std::vector<ColorLine> lines;
  for (const PointF& start : starts) lines.push_back({start, {}});
  return line_kmeans(points, std::move(lines), options);
}

LineKMeansResult line_kmeans(const PointSet& points, std::vector<ColorLine> lines, const LineKMeansOptions& options) {
  assert(!lines.empty() && points.size() > 0);
  LineKMeansResult result{.lines = std::move(lines), .labels = {}, .costs = {}, .squared_error = 0};
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    result.labels = assign(points, result.lines, options.along_weight);
    fill_empty_classes(points, result.lines, options.along_weight, result.labels);
    const std::vector<Moments> moments = class_moments(points, result.labels, result.lines.size());
    Fit fit = fit_lines(moments, result.lines, points.dimension, options.along_weight);
    result.lines = std::move(fit.lines);
    result.squared_error = fit.squared_error / points.size();
    const double cost = fit.cost / points.size();
    const bool settled = !result.costs.empty() && result.costs.back() - cost <= options.least_gain * cost;
    result.costs.push_back(cost);
    if (settled) break;
  }
  return result;
}

}  // namespace texbake
