// Good color lines from scratch, and how many of them an exemplar needs.
// Based on: Vanhoey et al. 2013, §4: octree-quantized starts at several scalings of the luminance, least error kept.
#pragma once

#include "libbake/color/line_kmeans.h"

namespace texbake {

/// The result of least cost over all starts, the first of equals; `classes` lines, fewer when the points fall into
/// fewer cells of the octree.
LineKMeansResult best_lines(const PointSet& points, int classes, float along_weight);

/// The same for the number of classes where one more stops paying: neither the next class nor the next two lower the
/// cost by the share that the hues people name in photographs do, or what is left cannot be seen. 3 … 8, fewer only
/// when there are fewer different points.
LineKMeansResult best_lines_of_auto_count(const PointSet& points, float along_weight);

}  // namespace texbake
