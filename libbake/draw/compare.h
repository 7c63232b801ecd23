// How two frames differ: what `texbake verify` reports of a shader or of an engine's frames.
#pragma once

#include <cstdint>
#include <optional>

#include "libbake/draw/frame.h"

namespace texbake {

/// The pixel that differs most.
struct WorstPixel {
  int x = 0, y = 0;
  V3f expected{0}, found{0};
  float difference = 0;  ///< greatest over the channels; infinity where one side is NaN
};

/// Differences of values. A NaN differs from everything, from another NaN too.
struct ValueComparison {
  uint64_t pixels = 0;
  uint64_t differing_pixels = 0;    ///< by more than the tolerance
  uint64_t differing_bits = 0;      ///< of all float channels, tolerance or not
  uint64_t nan_pixels = 0;          ///< NaN on either side
  double mean_difference = 0;       ///< of the greatest difference of each pixel, over those that are not NaN
  std::optional<WorstPixel> worst;  ///< nothing when all bits are equal
};

/// Throws Error(bad_data) naming both sizes when they differ. `tolerance` is absolute, in the values' unit.
ValueComparison compare_values(ImageView<const V3f> expected, ImageView<const V3f> found, float tolerance);

struct DecisionComparison {
  uint64_t pixels = 0;
  uint64_t differing_pixels = 0;
  V2i first{0, 0};  ///< the first that differs, in row order
};
DecisionComparison compare_decisions(ImageView<const PixelDecision> expected, ImageView<const PixelDecision> found);

/// The first three channels.
Image<V3f> color_values(ImageView<const glsl::vec4> values);

/// |expected − found| of each channel, times `gain`; 1 in every channel where a side is NaN.
Image<V3f> difference_picture(ImageView<const V3f> expected, ImageView<const V3f> found, float gain);

}  // namespace texbake
