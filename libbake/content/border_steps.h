// How visible the borders of patches are with contents on both sides, texel by texel.
// Based on: quality measures of seams against the exemplar's own steps. The impact of Vanhoey et al. 2013, eq. 2, knows
// mean colors of classes and the original neighbor alone; at run time both sides have exchanged their contents.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

/// Keeps, for every content that a patch may have, how visibly it steps against all that its neighbors have now.
/// Sums are integers, so that they do not depend on the order of changes.
class BorderSteps {
 public:
  /// `numbered[P]` are the contents that patch P may have, known by their number; no patch has one yet. `base_luv` is
  /// the base in CIELUV. All three are borrowed. At most kPairsPerBorder pairs of texels across the border of two
  /// patches are looked at, spread evenly.
  BorderSteps(const std::vector<std::vector<Content>>& numbered, ImageView<const V3f> base_luv,
              const Partition& patches);

  void add(size_t patch, size_t number) { change(patch, number, 1); }
  void remove(size_t patch, size_t number) { change(patch, number, -1); }

  /// The mean, over the texels at the patch's borders and what its neighbors have, of
  ///   P(step > own) + ½ P(step = own) + ½ [step > 95th percentile of own],
  /// where own are the base's steps across all borders before any exchange, in sixteenths of ΔE: 0.525 where nothing
  /// is exchanged, 0 … 1.5. Nothing to see, 0, for a patch whose neighbors have no content.
  double visibility(size_t patch, size_t number) const;

 private:
  static constexpr int kSteps = 2048;  ///< what is beyond counts as the last one

  // The border of a patch towards one other, from the patch's side.
  struct Side {
    size_t other = 0;
    std::vector<V2i> inside;   ///< texels of the patch
    std::vector<V2i> outside;  ///< their neighbors in `other`
  };

  int step(const V3f& a, const V3f& b) const;
  V3f shown(size_t patch, V2i p, size_t number) const;
  void find_sides();
  void weigh_steps();
  void change(size_t patch, size_t number, int sign);

  const std::vector<std::vector<Content>>& numbered_;
  ImageView<const V3f> luv_;
  const Partition& patches_;
  std::vector<std::vector<Side>> sides_;      // of each patch
  std::array<int64_t, kSteps> visibility_{};  // of each step, in 1/kOne
  std::vector<std::vector<int64_t>> sums_;    // of each patch and number, over its pairs and the neighbors' contents
  std::vector<int64_t> counts_;               // of each patch
};

}  // namespace texbake
