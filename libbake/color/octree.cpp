// The tree is kept as its list of leaves, sorted by the path from the root: the leaves of one node are neighbors
// there.
#include "libbake/color/octree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texbake {
namespace {

constexpr int kDepth = 8;
constexpr size_t kFewLeaves = 64;  // reducing a whole node is too coarse a step below this

struct Leaf {
  uint32_t path = 0;  // `dimension` bits for each level, the root's choice highest
  double count = 0;
  std::array<double, 4> sum{};

  void add(const Leaf& other) {
    count += other.count;
    for (size_t c = 0; c < sum.size(); ++c) sum[c] += other.sum[c];
  }
  std::array<double, 4> mean() const { return {sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count}; }
};

// Consecutive leaves below one node.
struct Node {
  size_t begin = 0, end = 0;
  double count = 0;
};

// A cube around all points, lightness scaled.
struct Cube {
  std::array<float, 4> scale{1, 1, 1, 1};
  std::array<float, 4> origin{};
  float cells_per_unit = 0;

  uint32_t path(const PointF& point, int dimension) const {
    uint32_t path = 0;
    for (size_t c = 0; c < static_cast<size_t>(dimension); ++c) {
      const float cell = std::floor((point[c] * scale[c] - origin[c]) * cells_per_unit);
      const auto bits = static_cast<uint32_t>(std::clamp(cell, 0.0f, static_cast<float>((1 << kDepth) - 1)));
      for (int level = 0; level < kDepth; ++level)
        path |= ((bits >> level) & 1) << (level * dimension + static_cast<int>(c));
    }
    return path;
  }
};

Cube bounding_cube(const PointSet& points, float lightness_scale) {
  Cube cube;
  cube.scale[0] = lightness_scale;
  std::array<float, 4> center{};
  float side = 0;
  for (size_t c = 0; c < static_cast<size_t>(points.dimension); ++c) {
    const auto [low, high] = std::minmax_element(points.coordinates[c].begin(), points.coordinates[c].end());
    side = std::max(side, (*high - *low) * cube.scale[c]);
    center[c] = (*high + *low) * 0.5f * cube.scale[c];
  }
  for (size_t c = 0; c < center.size(); ++c) cube.origin[c] = center[c] - side * 0.5f;
  if (side > 0) cube.cells_per_unit = static_cast<float>(1 << kDepth) / side;
  return cube;
}

std::vector<Leaf> finest_leaves(const PointSet& points, const Cube& cube) {
  std::vector<uint64_t> path_and_point;
  for (int i = 0; i < points.size(); ++i)
    path_and_point.push_back(static_cast<uint64_t>(cube.path(points.point(i), points.dimension)) << 32 |
                             static_cast<uint32_t>(i));
  std::sort(path_and_point.begin(), path_and_point.end());
  std::vector<Leaf> leaves;
  for (const uint64_t key : path_and_point) {
    const auto path = static_cast<uint32_t>(key >> 32);
    if (leaves.empty() || leaves.back().path != path) leaves.push_back({.path = path, .count = 0, .sum = {}});
    const PointF point = points.point(static_cast<int>(key & 0xffffffff));
    leaves.back().count += 1;
    for (size_t c = 0; c < point.size(); ++c) leaves.back().sum[c] += point[c];
  }
  return leaves;
}

// The nodes above `leaves` whose paths share all but the lowest `bits` bits, those of fewest texels first.
std::vector<Node> reducible_nodes(const std::vector<Leaf>& leaves, int bits) {
  std::vector<Node> nodes;
  for (size_t i = 0; i < leaves.size(); ++i) {
    if (i == 0 || static_cast<uint64_t>(leaves[i].path) >> bits != static_cast<uint64_t>(leaves[i - 1].path) >> bits)
      nodes.push_back({i, i, 0});
    nodes.back().end = i + 1;
    nodes.back().count += leaves[i].count;
  }
  std::stable_sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.count < b.count; });
  return nodes;
}

// Reduces nodes of one level while there are more than `enough` leaves.
void reduce_level(std::vector<Leaf>& leaves, int bits, size_t enough) {
  size_t left = leaves.size();
  for (const Node& node : reducible_nodes(leaves, bits)) {
    if (left <= enough) break;
    for (size_t i = node.begin + 1; i < node.end; ++i) {
      leaves[node.begin].add(leaves[i]);
      leaves[i].count = 0;
    }
    left -= node.end - node.begin - 1;
  }
  std::erase_if(leaves, [](const Leaf& leaf) { return leaf.count == 0; });
}

// Makes one of the two leaves whose union adds least squared error, the first pair of equals.
void merge_cheapest(std::vector<Leaf>& leaves, const std::array<float, 4>& scale) {
  std::vector<std::array<double, 4>> means;
  for (const Leaf& leaf : leaves) means.push_back(leaf.mean());
  double least = std::numeric_limits<double>::infinity();
  size_t first = 0, second = 1;
  for (size_t i = 0; i < leaves.size(); ++i)
    for (size_t j = i + 1; j < leaves.size(); ++j) {
      double squared = 0;
      for (size_t c = 0; c < scale.size(); ++c) {
        const double difference = scale[c] * (means[i][c] - means[j][c]);
        squared += difference * difference;
      }
      const double cost = squared * leaves[i].count * leaves[j].count / (leaves[i].count + leaves[j].count);
      if (cost >= least) continue;
      least = cost;
      first = i;
      second = j;
    }
  leaves[first].add(leaves[second]);
  leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(second));
}

}  // namespace

std::vector<PointF> octree_quantize(const PointSet& points, int count, float lightness_scale) {
  if (points.size() == 0) return {};
  const Cube cube = bounding_cube(points, lightness_scale);
  std::vector<Leaf> leaves = finest_leaves(points, cube);
  const size_t wanted = static_cast<size_t>(count), few = std::max<size_t>(kFewLeaves, 2 * wanted);
  for (int level = 1; level <= kDepth; ++level) reduce_level(leaves, level * points.dimension, few);
  while (leaves.size() > wanted) merge_cheapest(leaves, cube.scale);

  std::vector<PointF> means;
  for (const Leaf& leaf : leaves) {
    const std::array<double, 4> mean = leaf.mean();
    means.push_back({static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2]),
                     static_cast<float>(mean[3])});
  }
  return means;
}

}  // namespace texbake
