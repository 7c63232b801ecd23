// The local descriptor of eq. 6: gradients of the variation coordinate at several smoothings around a texel.
// Based on: Vanhoey et al. 2013, §7, eq. 6 and 7.
#pragma once

#include <array>
#include <vector>

#include "libbake/color/palette.h"

namespace texbake {

inline constexpr int kDescriptorScales = 6;  ///< N_σ: σ = 1 … 6 px
inline constexpr int kDescriptorGradients = 9 * kDescriptorScales;

/// Gradients (x, y) of v_σ at the texel and its 8 neighbors, scale by scale, rows of the 3 × 3 from the top.
using Descriptor = std::array<float, 2 * kDescriptorGradients>;

/// Σ over all 54 gradients of the length of their difference: eq. 7.
float descriptor_distance(const float* a, const float* b);

/// Gradients of v smoothed inside one color class (normalized convolution: texels of other classes weigh nothing).
class ClassGradients {
 public:
  ClassGradients(const PrincipalVariation& colors, uint8_t class_idx);

  Descriptor at(V2i texel) const;
  /// As if the picture were turned by `angle_rad` about the texel: offsets and gradient vectors turn, and the gradients
  /// are read between texels bilinearly.
  Descriptor turned(V2i texel, double angle_rad) const;

 private:
  V2f gradient(int scale, V2f position) const;

  std::vector<Image<V2f>> gradients_;  ///< one for each scale
};

}  // namespace texbake
