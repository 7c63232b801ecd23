// Distances between content classes as whole numbers, so that sums of eq. 3 are exact in any order and on any machine.
// Based on: Vanhoey et al. 2013, §5.2, δ of eq. 3.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libbake/base/torus.h"

namespace texbake {

inline constexpr int kMaskRadius = 3;  ///< M is a mask of (2·3 + 1)² ones
inline constexpr int kMaskSide = 2 * kMaskRadius + 1;
/// The largest distance in steps. A distance is a byte, the sum of 49 of them 16 bits, E 22 bits: the search runs along
/// short vector lanes. Half a step is 1/510 of the largest ΔE²: at most 1/22 of the largest ΔE.
inline constexpr int kMaxDistanceSteps = 255;
inline constexpr int kMaxContentClasses = 128;

/// δ between classes: ‖C_a − C_b‖² in steps of `step`, rounded to the nearest.
struct ClassDistances {
  int class_count = 0;
  double step = 1;             ///< ΔE² of one step; the farthest two classes are kMaxDistanceSteps apart
  std::vector<uint8_t> steps;  ///< class_count², symmetric, 0 on the diagonal

  uint8_t at(int a, int b) const {
    return steps[static_cast<size_t>(a) * static_cast<size_t>(class_count) + static_cast<size_t>(b)];
  }
  /// I of eq. 2 in ΔE⁴ from a sum of E over `border_count` texels.
  double impact(uint64_t error_sum, size_t border_count) const {
    return border_count == 0 ? 0.0 : static_cast<double>(error_sum) * step * step / static_cast<double>(border_count);
  }
};

/// `mean_luv` holds the mean color of each class, 1 … kMaxContentClasses of them.
ClassDistances class_distances(std::span<const V3f> mean_luv);

}  // namespace texbake
