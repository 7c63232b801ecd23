// The dilated borders of all patches, cut into chunks whose errors are summed for many translations at once.
//
// E(p, p+t) of eq. 3 does not know to which patch p belongs, so borders that two patches share are summed once for
// both. A chunk is a block of the torus; its border texels are reached row by row (or column by column, where borders
// run downwards: see Rows), and M ∗ δ by running sums:
//
//   fetch   δ of a row, three rows ahead of the errors      . . . x x x x . .
//   open    column sums of seven rows of δ, from nothing      | | | |
//   slide   fetch, and the column sums of the row above moved down by one row
//   sum     E of a run of texels: the window of seven column sums slides along the row
//   extend  the same for the run that follows it directly but counts for other patches: the window is kept
//
// Based on: Vanhoey et al. 2013, §5.2, eq. 2 and 3.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/content/class_distances.h"
#include "libbake/content/patch_border.h"

namespace texbake {

/// Texels: larger blocks share more of δ, smaller ones keep it in the nearest cache.
inline constexpr int kChunkSide = 48;
inline constexpr int kChunkStride = kChunkSide + 2 * kMaskRadius;  ///< columns of δ that a chunk needs

enum class SegmentKind : uint8_t { fetch, open, slide, sum, extend };

/// One step of a chunk: `count` columns from `x` of row `y`, in the frame of the chunk, see Chunk::texel. For `open`
/// and `slide` the row is the middle of the column sums, kMaskRadius above the row that is fetched.
struct Segment {
  SegmentKind kind;
  uint8_t y;
  uint8_t x;
  uint8_t count;
  uint32_t sum = 0;  ///< for `sum` and `extend`: into which of the chunk's sums
};

/// A sum of E over part of a chunk, and the patches whose impact it belongs to.
struct ChunkSum {
  std::vector<uint32_t> patches;
  uint64_t bound = 0;  ///< no translation gives more; below 2^32
};

/// How the rows of a chunk's frame lie on the tile: along the borders, so that its segments are long.
enum class Rows : uint8_t { across, down };

/// A block and its frame, which begins kMaskRadius texels left of and above it.
struct Chunk {
  V2i origin{0, 0};  ///< of the frame: −kMaskRadius … size−1−kMaskRadius
  Rows rows = Rows::across;
  int texel_count = 0;
  double expected_error = 0;  ///< roughly, for a translation taken at random
  std::vector<Segment> segments;
  std::vector<ChunkSum> sums;

  /// The texel of the tile, not wrapped, at column x and row y of the frame.
  V2i texel(int x, int y) const { return origin + (rows == Rows::across ? V2i(x, y) : V2i(y, x)); }
};

using BorderProgram = std::vector<Chunk>;

/// Chunks in row order. Every texel of every dilated border is in exactly one chunk.
BorderProgram border_program(const PatchBorders& borders, ImageView<const uint8_t> classes,
                             const ClassDistances& distances);

}  // namespace texbake
