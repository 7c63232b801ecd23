// What noise adds to the light of a texel on the average over all places at which its content is seen.
#pragma once

#include <span>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/color/noise_space.h"

namespace texbake {

/// In light the noises' means, times their weights. In its square root E[(√s + n)²] − s = 2 √s E[n] + E[n²], where n is
/// the weighted sum of the noises, which are not independent: their phases are shared.
class NoiseMean {
 public:
  NoiseMean() = default;
  /// Of noises of one size.
  NoiseMean(std::span<const ImageView<const V3f>> noises, NoiseSpace space);

  /// To a structure, linear Rec.709, by the weights of the noises, 0 … 1.
  Imath::V3d change(const V3f& structure, const Imath::V4f& weights) const;

 private:
  NoiseSpace space_ = NoiseSpace::root;
  std::vector<Imath::V3d> means_;
  std::vector<Imath::V3d> products_;  ///< of noises k and l: at k · count + l
};

}  // namespace texbake
