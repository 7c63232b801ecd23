// A few representative colors of many, by an octree over color space.
// Based on: Gervautz & Purgathofer 1990, "A simple method for color quantization: octree quantization".
#pragma once

#include "libbake/color/point_set.h"

namespace texbake {

/// Means of at most `count` (1 … 64) disjoint groups of points; exactly `count` when the points fall into so many
/// cells of the finest level (1/256 of the longest extent). Nodes are reduced deepest first, fewest texels first, while
/// there are many; the last are merged in pairs, those first that add least squared error. Reducing whole nodes to the
/// end would leave the octants of the bounding cube, whatever the scale. Lightness is multiplied by
/// `lightness_scale` > 0 while grouping: small values group by hue, large ones by lightness. Points of four dimensions
/// use a tree of sixteen children.
std::vector<PointF> octree_quantize(const PointSet& points, int count, float lightness_scale);

}  // namespace texbake
