// K-means in which a class is a line: a dominant color and a direction of variation.
// Based on: Vanhoey et al. 2013, §4, eq. 1.
#pragma once

#include <span>
#include <vector>

#include "libbake/color/point_set.h"
#include "libbake/color/principal_axis.h"

namespace texbake {

/// D_i and V_i of one class, in the coordinates of the points. V_i = 0 is a class of one color.
struct ColorLine {
  PointF point{};
  PointF direction{};
};

/// A point belongs to the line of least r² + w t², where r is its distance to the line and t its coordinate along the
/// line: w = 0 is eq. 1, w = 1 is ordinary K-means. The lowest index wins ties.
struct LineKMeansOptions {
  float along_weight = 0;
  int max_iterations = 100;
  double least_gain = 1e-5;  ///< stops when an iteration lowers the mean cost by a smaller share
};

struct LineKMeansResult {
  std::vector<ColorLine> lines;  ///< one for each start
  std::vector<uint8_t> labels;   ///< of the last assignment, from which the lines are made
  std::vector<double> costs;     ///< mean of r² + w t² after each iteration; never increases
  double squared_error = 0;      ///< eq. 1 divided by the number of points
};

/// Assigns `count` points to lines; `coordinates` are the starts of each coordinate's array, `labels` has `count`
/// places.
void assign_to_lines(const std::array<const float*, 4>& coordinates, int dimension, int count,
                     std::span<const ColorLine> lines, float along_weight, uint8_t* labels);

/// r² + w t² of one point.
float line_cost(const PointF& point, const ColorLine& line, float along_weight);

/// From classes that are single colors. A class that becomes empty takes the point of greatest cost; it stays empty
/// only where no point has a cost. 1 … 64 starts, at least one point.
LineKMeansResult line_kmeans(const PointSet& points, std::span<const PointF> starts, const LineKMeansOptions& options);
/// From lines found before.
LineKMeansResult line_kmeans(const PointSet& points, std::vector<ColorLine> lines, const LineKMeansOptions& options);

}  // namespace texbake
