// A partition of the torus into shapes that each unwrap to the plane: what fragments and patches have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// In which repetition of the tile the shape of a texel has its centre, relative to the texel's own: −1, 0 or 1 each.
struct OwnerOffset {
  int8_t x = 0;
  int8_t y = 0;
  bool operator==(const OwnerOffset&) const = default;
};

/// Every texel belongs to exactly one shape. A shape is 4-connected on the torus and unwraps consistently to Z²: texel
/// p of a shape lies at p − owner(p) · size in the frame whose tile holds the centre, and two texels of the shape that
/// are neighbours on the torus are neighbours there. Its unwrapped bounding box is less than half the tile on each axis.
struct Partition {
  Image<uint32_t> idx;         ///< shape of each texel, 0 … count−1, all used
  Image<OwnerOffset> owner;    ///< see OwnerOffset
  std::vector<V2i> centers;    ///< centroid of each unwrapped shape, rounded half up, in 0 … size−1
  std::vector<uint32_t> areas_px;

  int count() const { return static_cast<int>(centers.size()); }
};

/// Computes owner offsets, centres and areas of the shapes in `idx` (dense, 0 … count−1), breadth first from the first
/// texel of each shape in row order. Throws Error(bad_data) naming the first shape that is not connected, does not
/// unwrap consistently, or whose bounding box is not less than half the tile.
Partition unwrap(Image<uint32_t> idx);

/// What is wrong with a partition read from a file, or nothing: used by `texbake verify`.
struct PartitionFault {
  enum class Kind { idx_out_of_range, empty_shape, not_connected, inconsistent_owner, too_large, wrong_center } kind;
  uint32_t shape = 0;
  V2i texel{0, 0};
};
std::vector<PartitionFault> check_partition(const Partition& partition);

}  // namespace texbake
