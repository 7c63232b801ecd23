// The colors of an exemplar as points: (L, u*, v*) and, where there is relief, the weighted height as fourth.
// Based on: Vanhoey et al. 2013, §4 and §7.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

using PointF = std::array<float, 4>;

/// Coordinates lie in one array each, so that loops over points use the vector lanes.
struct PointSet {
  int dimension = 3;  ///< 3 or 4
  std::array<std::vector<float>, 4> coordinates;

  int size() const { return static_cast<int>(coordinates[0].size()); }
  PointF point(int i) const;
  std::array<const float*, 4> data(int first = 0) const;  ///< each coordinate from point `first` on
  void resize(int size);
  void set(int i, const PointF& point);
  void append(const PointF& point);
};

/// Where the colors and heights of an exemplar come from. `height_01` is empty or of the exemplar's size.
struct PointSource {
  ImageView<const V3f> exemplar;  ///< linear Rec.709
  ImageView<const float> height_01;
  float height_weight = 0;  ///< ΔE per unit height

  int dimension() const { return height_01.empty() ? 3 : 4; }
  PointF point(int x, int y) const;
};

/// At most `max_count` points, one from each cell of a grid at a seeded place in the cell, so that neither stripes nor
/// weaves beat with the grid; all texels in row order when they are no more than `max_count`.
PointSet sample(const PointSource& source, int max_count);

/// The different points in row order, at most `limit`: fewer than `limit` are all there are.
std::vector<PointF> distinct_points(const PointSource& source, size_t limit);

}  // namespace texbake
