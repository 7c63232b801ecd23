// A partition of the torus into shapes that each unwrap to the plane: what fragments and patches have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// In which repetition of the tile the shape of a texel has its center, relative to the texel's own: −1, 0 or 1 each.
struct OwnerOffset {
  int8_t x = 0;
  int8_t y = 0;
  bool operator==(const OwnerOffset&) const = default;
};

/// Every texel belongs to exactly one shape. A shape is 4-connected on the torus and unwraps consistently to Z²: texel
/// p of a shape lies at p − owner(p) · size in the frame whose tile holds the center, and two texels of the shape that
/// are neighbors on the torus are neighbors there. Its unwrapped bounding box is less than half the tile on each
/// axis.
struct Partition {
  Image<uint32_t> idx;       ///< shape of each texel, 0 … count−1, all used
  Image<OwnerOffset> owner;  ///< see OwnerOffset
  std::vector<V2i> centers;  ///< centroid of each unwrapped shape, rounded half up, in 0 … size−1
  std::vector<uint32_t> areas_px;

  int count() const { return static_cast<int>(centers.size()); }
  V2i size() const { return {idx.width(), idx.height()}; }
  /// Where texel (x, y) lies in the frame whose tile holds the center of its shape.
  V2i unwrapped(int x, int y) const {
    const OwnerOffset o = owner(x, y);
    return {x - o.x * idx.width(), y - o.y * idx.height()};
  }
};

/// The widest unwrapped bounding box, in texels, of a shape on a tile of `size_px` on that axis: less than half.
inline int max_extent(int size_px) { return (size_px - 1) / 2; }

/// The integer texel nearest to the mean of `count` > 0 coordinates whose sum is `sum`; a half rounds up.
inline int64_t rounded_mean(int64_t sum, int64_t count) {
  const int64_t twice = 2 * sum + count;
  const int64_t quotient = twice / (2 * count);
  return twice < 0 && quotient * 2 * count != twice ? quotient - 1 : quotient;
}

/// Computes owner offsets, centers and areas of the shapes in `idx` (dense, 0 … count−1), breadth first from the first
/// texel of each shape in row order. Throws Error(bad_data) naming the first shape that is empty, is not connected, or
/// does not unwrap to a bounding box of less than half the tile; a shape that winds around the torus never does.
Partition unwrap(Image<uint32_t> idx);

/// What is wrong with a partition read from a file: used by `texbake verify`.
struct PartitionFault {
  enum class Kind {
    idx_out_of_range,
    empty_shape,
    not_connected,
    inconsistent_owner,
    too_large,
    wrong_center,
    wrong_area
  } kind;
  uint32_t shape = 0;
  V2i texel{0, 0};     ///< the first in row order that shows the fault
  uint64_t count = 1;  ///< texels that show it; 1 for a fault of the shape as a whole
};

/// Every fault of `partition`, shape by shape, at most one of a kind for each shape and one idx_out_of_range in all;
/// empty when it is whole. Linear time. `owner` has the size of `idx`, `areas_px` the size of `centers`.
std::vector<PartitionFault> check_partition(const Partition& partition);

}  // namespace texbake
