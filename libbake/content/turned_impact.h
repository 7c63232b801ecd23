// The exact impact of single contents, turned and scaled as the evaluator draws them.
// Based on: Vanhoey et al. 2013, eq. 2-3; Guingo et al. 2017, §4.
#pragma once

#include <span>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/content/class_distances.h"
#include "libbake/content/content.h"

namespace texbake {

/// Sums eq. 3 for one patch. Keeps buffers: one for each thread.
class TurnedImpact {
 public:
  /// `border` holds the offsets of dil(∂P) from `center`, the center of the patch. `classes` is borrowed.
  TurnedImpact(ImageView<const uint8_t> classes, const ClassDistances& distances, std::span<const V2i> border,
               V2i center);

  /// Σ E over the border, in squared distance steps, with δ(p) = ‖C(p) − C(source of p)‖² everywhere in the mask too.
  uint64_t error_sum(const Content& content);

 private:
  // Texels of one row that are next to each other.
  struct Run {
    int x, y, count;
  };
  void find_rows(std::span<const V2i> border);
  void turn(const Content& content);
  void measure_distances(V2i translation);

  ImageView<const uint8_t> classes_;
  const ClassDistances& distances_;
  V2i center_;
  V2i origin_;                // of the frame, from the center: everything within the mask of the border lies in it
  std::vector<Run> runs_;     // of the border, row by row, in the frame
  std::vector<V2i> seen_;     // texels within the mask of the border, in the frame
  std::vector<uint8_t> own_;  // their classes
  Content turned_;            // what `sources_` stands for
  std::vector<V2i> sources_;  // where they are turned to, from the center, before the translation
  Image<uint8_t> delta_;      // of the frame; 0 where not seen
  std::vector<uint16_t> columns_;
};

}  // namespace texbake
