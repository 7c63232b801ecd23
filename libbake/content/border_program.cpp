#include "libbake/content/border_program.h"

#include <algorithm>
#include <limits>
#include <map>

namespace texbake {
namespace {

// Which columns of each row of a chunk's frame are in use.
class Mask {
 public:
  bool operator()(int x, int y) const { return bits_[index(x, y)]; }
  void set(int x, int y) { bits_[index(x, y)] = 1; }

 private:
  static size_t index(int x, int y) { return static_cast<size_t>(y * kChunkStride + x); }
  std::vector<uint8_t> bits_ = std::vector<uint8_t>(static_cast<size_t>(kChunkStride * kChunkStride), 0);
};

// What δ can be at a texel of each class.
struct DistanceRange {
  std::vector<uint64_t> farthest;
  std::vector<double> mean;  // over all texels of the tile
};

DistanceRange distance_range(ImageView<const uint8_t> classes, const ClassDistances& distances) {
  std::vector<uint64_t> texel_counts(static_cast<size_t>(distances.class_count), 0);
  for (const uint8_t class_idx : classes) ++texel_counts[class_idx];
  DistanceRange range;
  for (int a = 0; a < distances.class_count; ++a) {
    uint64_t farthest = 0;
    uint64_t sum = 0;
    for (int b = 0; b < distances.class_count; ++b) {
      farthest = std::max<uint64_t>(farthest, distances.at(a, b));
      sum += distances.at(a, b) * texel_counts[static_cast<size_t>(b)];
    }
    range.farthest.push_back(farthest);
    range.mean.push_back(static_cast<double>(sum) / static_cast<double>(classes.size()));
  }
  return range;
}

// Makes the segments of one chunk.
class ChunkMaker {
 public:
  ChunkMaker(const PatchBorders& borders, ImageView<const uint8_t> classes, const DistanceRange& range, V2i block,
             Rows rows)
      : borders_(borders), classes_(classes), range_(range), size_(classes.width(), classes.height()) {
    chunk_.origin = block - V2i(kMaskRadius, kMaskRadius);
    chunk_.rows = rows;
    find_texels(block);
  }

  Chunk make() {
    for (int y = 0; y < kChunkStride; ++y) {
      // Row y completes the column sums of the row three above it.
      const int row = y - kMaskRadius;
      const bool has_errors = row >= kMaskRadius && row < kMaskRadius + kChunkSide;
      const auto opens = [&](int x) { return has_errors && summed_(x, row) && !summed_(x, row - 1); };
      const auto slides = [&](int x) { return has_errors && summed_(x, row) && summed_(x, row - 1); };
      add_segments(SegmentKind::fetch, y, [&](int x) { return fetched_(x, y) && !slides(x); });
      add_segments(SegmentKind::open, row, opens);
      add_segments(SegmentKind::slide, row, slides);
      if (has_errors) add_error_segments(row);
    }
    return std::move(chunk_);
  }

 private:
  void find_texels(V2i block) {
    const V2i end(std::min(block.x + kChunkSide, size_.x), std::min(block.y + kChunkSide, size_.y));
    for (int y = block.y; y < end.y; ++y)
      for (int x = block.x; x < end.x; ++x)
        if (borders_.set_idx(x, y) != 0) {
          const V2i p = V2i(x, y) - chunk_.origin;
          add_texel(chunk_.rows == Rows::across ? p : V2i(p.y, p.x));
        }
  }
  void add_texel(V2i p) {
    ++chunk_.texel_count;
    texels_.set(p.x, p.y);
    for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) {
      summed_.set(p.x + dx, p.y);
      for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy) fetched_.set(p.x + dx, p.y + dy);
    }
  }

  template <class InSegment>
  void add_segments(SegmentKind kind, int y, const InSegment& in_segment) {
    for (int x = 0; x < kChunkStride; ++x) {
      if (!in_segment(x)) continue;
      const int begin = x;
      while (x < kChunkStride && in_segment(x)) ++x;
      chunk_.segments.push_back(
          {kind, static_cast<uint8_t>(y), static_cast<uint8_t>(begin), static_cast<uint8_t>(x - begin)});
    }
  }

  // Runs of texels that belong to the same patches.
  void add_error_segments(int y) {
    for (int x = kMaskRadius; x < kChunkStride; ++x) {
      if (!texels_(x, y)) continue;
      const uint32_t set = set_at(x, y);
      const int begin = x;
      uint64_t bound = 0;
      for (; x < kChunkStride && texels_(x, y) && set_at(x, y) == set; ++x) {
        bound += error_at(range_.farthest, x, y);
        chunk_.expected_error += error_at(range_.mean, x, y);
      }
      const bool follows = texels_(begin - 1, y);
      chunk_.segments.push_back({follows ? SegmentKind::extend : SegmentKind::sum, static_cast<uint8_t>(y),
                                 static_cast<uint8_t>(begin), static_cast<uint8_t>(x - begin), sum_for(set, bound)});
      --x;
    }
  }

  // The sum to which `bound` more can be added without passing 32 bits, a new one if need be.
  uint32_t sum_for(uint32_t set, uint64_t bound) {
    const auto open = open_sum_.find(set);
    if (open == open_sum_.end() || chunk_.sums[open->second].bound + bound > std::numeric_limits<uint32_t>::max()) {
      open_sum_[set] = static_cast<uint32_t>(chunk_.sums.size());
      chunk_.sums.push_back({borders_.sets[set], 0});
    }
    chunk_.sums[open_sum_[set]].bound += bound;
    return open_sum_[set];
  }

  // E at a texel where δ is as given for each class.
  template <class T>
  T error_at(const std::vector<T>& delta, int x, int y) const {
    T around = 0;
    for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy)
      for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) around += delta[class_at(x + dx, y + dy)];
    return around * delta[class_at(x, y)];
  }

  V2i texel(int x, int y) const { return wrap(chunk_.texel(x, y), size_); }
  uint8_t class_at(int x, int y) const { return classes_(texel(x, y).x, texel(x, y).y); }
  uint32_t set_at(int x, int y) const { return borders_.set_idx(texel(x, y).x, texel(x, y).y); }

  const PatchBorders& borders_;
  ImageView<const uint8_t> classes_;
  const DistanceRange& range_;
  V2i size_;
  Chunk chunk_;
  Mask texels_;   // of the border
  Mask summed_;   // whose column sums are needed
  Mask fetched_;  // whose δ is needed
  std::map<uint32_t, uint32_t> open_sum_;
};

// Roughly the time that a chunk takes, in half the time of a fetched texel; shares of a profile.
int cost(const Chunk& chunk) {
  constexpr int kCostPerColumn[] = {2, 6, 3, 3, 3};  // by SegmentKind
  constexpr int kCostPerSegment[] = {2, 2, 2, 9, 7};
  int sum = 0;
  for (const Segment& segment : chunk.segments) {
    const auto kind = static_cast<size_t>(segment.kind);
    sum += kCostPerColumn[kind] * segment.count + kCostPerSegment[kind];
  }
  return sum;
}

}  // namespace

BorderProgram border_program(const PatchBorders& borders, ImageView<const uint8_t> classes,
                             const ClassDistances& distances) {
  // A run never passes 32 bits on its own: its longest is kChunkSide texels of the largest E.
  static_assert(uint64_t{kChunkSide} * kMaxDistanceSteps * kMaxDistanceSteps * kMaskSide * kMaskSide <=
                std::numeric_limits<uint32_t>::max());
  const DistanceRange range = distance_range(classes, distances);
  BorderProgram program;
  for (int y = 0; y < classes.height(); y += kChunkSide)
    for (int x = 0; x < classes.width(); x += kChunkSide) {
      const Chunk across = ChunkMaker(borders, classes, range, {x, y}, Rows::across).make();
      if (across.texel_count == 0) continue;
      const Chunk down = ChunkMaker(borders, classes, range, {x, y}, Rows::down).make();
      program.push_back(cost(down) < cost(across) ? down : across);
    }
  return program;
}

}  // namespace texbake
