// Sums the errors of eq. 3 over the borders of all patches for 128 translations at once, along the vector lanes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "libbake/content/border_program.h"

namespace texbake {

/// Translations (x … x + 63, y … y + 1) are summed together: the unit in which the search gives up. The same on every
/// processor, whatever the length of its vectors, so that the work done is the same too.
inline constexpr int kGroupWidth = 64;
inline constexpr int kGroupRows = 2;
inline constexpr int kGroupSize = kGroupWidth * kGroupRows;

/// Classes and distances laid out for the kernel: the tile repeated, so that p + t needs no wrapping, and tables of 16
/// distances, the length of a byte shuffle.
class DistanceField {
 public:
  DistanceField(ImageView<const uint8_t> classes, const ClassDistances& distances);

  int plane_count() const { return plane_count_; }
  size_t plane_size() const { return plane_size_; }
  ptrdiff_t stride() const { return stride_; }
  /// The class of texel `p` ≥ −kMaskRadius of the repeated tile.
  const uint8_t* class_at(V2i p) const { return classes_.data() + offset(p); }
  /// The same in the planes, one every plane_size(): plane k holds classes 16k … 16k + 15 less 16k, and 128 elsewhere.
  const uint8_t* plane_at(V2i p) const { return planes_.data() + offset(p); }
  uint32_t distance(int a, int b) const { return distances_.at(a, b); }
  /// The distances from class a to the 16 classes of plane k, at 16 (a · plane_count() + k).
  const uint8_t* tables() const { return tables_.data(); }

 private:
  ptrdiff_t offset(V2i p) const { return (p.y + kMaskRadius) * stride_ + p.x + kMaskRadius; }

  ClassDistances distances_;
  int plane_count_;
  ptrdiff_t stride_;
  size_t plane_size_;
  std::vector<uint8_t> classes_;
  std::vector<uint8_t> planes_;
  std::vector<uint8_t> tables_;
};

/// The errors summed for one group, as far as they matter.
struct GroupSums {
  V2i translation{0, 0};       ///< the first of the group
  std::vector<uint8_t> alive;  ///< for each patch: some translation may still be at most its limit
  std::vector<int64_t> sums;   ///< patch-major, kGroupSize for each, row by row; complete where alive
  uint64_t error_count = 0;    ///< of E computed, kGroupSize for each texel
};

/// What a translation that must not be chosen starts with.
inline constexpr int64_t kExcluded = INT64_MAX / 2;

/// Adds the errors of the chunks of `program`, taken in `order`, to the sums of the groups. A patch is given up in a
/// group, alive = 0, once all of its sums there are beyond its limit; a chunk is skipped once all of its patches are.
/// Groups that are near each other read the same classes: together they wait less for memory.
void add_group_errors(const BorderProgram& program, const std::vector<uint32_t>& order, const DistanceField& field,
                      const std::vector<int64_t>& limits, std::span<GroupSums> groups);

}  // namespace texbake
