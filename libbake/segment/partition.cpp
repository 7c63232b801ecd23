#include "libbake/segment/partition.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "libbake/base/error.h"
#include "libbake/segment/neighbors.h"

namespace texbake {
namespace {

/// The bounding box and the sums of the positions seen so far.
struct Extent {
  V2i low{std::numeric_limits<int>::max()};
  V2i high{std::numeric_limits<int>::min()};
  int64_t sum_x = 0, sum_y = 0, count = 0;

  void add(V2i p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    sum_x += p.x;
    sum_y += p.y;
    ++count;
  }
  bool fits(V2i size) const {
    return count == 0 || (int64_t{high.x} - low.x < max_extent(size.x) && int64_t{high.y} - low.y < max_extent(size.y));
  }
  V2i center() const {
    return {static_cast<int>(rounded_mean(sum_x, count)), static_cast<int>(rounded_mean(sum_y, count))};
  }
};

/// Areas of the shapes 0 … max; throws where one is empty.
std::vector<uint32_t> areas_of(const Image<uint32_t>& idx) {
  const uint32_t last = *std::max_element(idx.begin(), idx.end());
  if (last >= idx.size())
    throw Error(ErrorKind::bad_data,
                fmt::format("partition: expected dense shapes 0 to at most {}, found shape {}", idx.size() - 1, last));
  std::vector<uint32_t> areas(size_t{last} + 1, 0);
  for (const uint32_t shape : idx) ++areas[shape];
  const auto empty = std::find(areas.begin(), areas.end(), 0u);
  if (empty != areas.end())
    throw Error(ErrorKind::bad_data, fmt::format("partition: expected dense shapes 0 to {}, found no texel of shape {}",
                                                 last, empty - areas.begin()));
  return areas;
}

/// A texel of a shape in the plane into which the shape is being unwrapped.
struct Unwrapped {
  V2i position;
  size_t at;
};

/// Visits the component of `start` breadth first; leaves in `tile` the repetition in which each of its texels lies and
/// in `queue` its texels. Stops where the bounding box reaches half the tile.
Extent flood(const Image<uint32_t>& idx, size_t start, Image<OwnerOffset>& tile, std::vector<uint8_t>& visited,
             std::vector<Unwrapped>& queue) {
  const V2i size(idx.width(), idx.height());
  const uint32_t shape = idx.data()[start];
  Extent extent;
  queue.assign(1, {texel_of(start, size), start});
  visited[start] = 1;
  extent.add(queue.front().position);
  for (size_t head = 0; head < queue.size() && extent.fits(size); ++head) {
    for (int n = 0; n < 4; ++n) {
      const V2i p(queue[head].position.x + kNeighborX[n], queue[head].position.y + kNeighborY[n]);
      const V2i q = wrap(p, size);
      const size_t at = position_of(q, size);
      if (visited[at] || idx.data()[at] != shape) continue;
      visited[at] = 1;
      extent.add(p);
      if (!extent.fits(size)) return extent;
      tile.data()[at] = {static_cast<int8_t>((p.x - q.x) / size.x), static_cast<int8_t>((p.y - q.y) / size.y)};
      queue.push_back({p, at});
    }
  }
  return extent;
}

}  // namespace

Partition unwrap(Image<uint32_t> idx) {
  Partition partition;
  if (idx.empty()) throw Error(ErrorKind::bad_data, "partition: expected a tile with texels, found an empty one");
  partition.areas_px = areas_of(idx);
  partition.idx = std::move(idx);
  const V2i size = partition.size();
  partition.owner = Image<OwnerOffset>(size.x, size.y);
  partition.centers.assign(partition.areas_px.size(), V2i(-1, -1));

  std::vector<uint8_t> visited(partition.idx.size(), 0);
  std::vector<Unwrapped> queue;
  for (size_t start = 0; start < partition.idx.size(); ++start) {
    if (visited[start]) continue;
    const uint32_t shape = partition.idx.data()[start];
    const V2i first = texel_of(start, size);
    if (partition.centers[shape].x >= 0)
      throw Error(ErrorKind::bad_data, fmt::format("partition: expected shape {} to be 4-connected on the torus, found "
                                                   "another piece of it at texel ({}, {})",
                                                   shape, first.x, first.y));
    const Extent extent = flood(partition.idx, start, partition.owner, visited, queue);
    if (!extent.fits(size))
      throw Error(ErrorKind::bad_data,
                  fmt::format("partition: expected shape {} to unwrap to at most {} x {} texels, less than half the "
                              "tile, found {} x {} or more, starting at texel ({}, {}); split it",
                              shape, max_extent(size.x), max_extent(size.y), extent.high.x - extent.low.x + 1,
                              extent.high.y - extent.low.y + 1, first.x, first.y));

    // From the repetition of each texel, relative to the first, to that of the center, relative to each texel.
    const V2i center = wrap(extent.center(), size);
    const V2i home((extent.center().x - center.x) / size.x, (extent.center().y - center.y) / size.y);
    for (const Unwrapped& texel : queue) {
      OwnerOffset& owner = partition.owner.data()[texel.at];
      owner = {static_cast<int8_t>(home.x - owner.x), static_cast<int8_t>(home.y - owner.y)};
    }
    partition.centers[shape] = center;
  }
  return partition;
}

}  // namespace texbake
