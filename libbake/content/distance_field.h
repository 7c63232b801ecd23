// Classes and distances laid out for the search: translations along the lanes of a vector.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/content/class_distances.h"

namespace texbake {

/// Translations (x … x + 63, y … y + 1) are summed together: the unit in which the search gives up. The same on every
/// processor, whatever the length of its vectors, so that the work done is the same too.
inline constexpr int kGroupWidth = 64;
inline constexpr int kGroupRows = 2;
inline constexpr int kGroupSize = kGroupWidth * kGroupRows;

/// The tile repeated, so that p + t needs no wrapping, and tables of 16 distances, the length of a byte shuffle.
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

}  // namespace texbake
