// Synthetic colors with known classes, for the tests of clustering.
#pragma once

#include <vector>

#include "libbake/base/random.h"
#include "libbake/color/line_kmeans.h"

namespace texbake {

inline PointSet point_set(const std::vector<PointF>& points, int dimension = 3) {
  PointSet set{.dimension = dimension, .coordinates = {}};
  for (const PointF& point : points) set.append(point);
  return set;
}

/// Roughly normal with standard deviation 1: twelve uniform numbers have variance 1.
inline float normal(Random& random) {
  float sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

/// A cluster of standard deviation `along` on the line and `across` in every coordinate beside it.
inline void add_cluster(PointSet& points, Random& random, const ColorLine& line, int count, float along, float across) {
  for (int i = 0; i < count; ++i) {
    const float t = along * normal(random);
    PointF point{};
    for (size_t c = 0; c < static_cast<size_t>(points.dimension); ++c)
      point[c] = line.point[c] + t * line.direction[c] + across * normal(random);
    points.append(point);
  }
}

}  // namespace texbake
