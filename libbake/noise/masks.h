// Masks: where each noise lives. K-means of grain features, binary or soft.
// Based on: Guingo et al. 2017, §3.3 and Fig. 6-7.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/options.h"
#include "libbake/noise/grain_features.h"
#include "libbake/noise/k_means.h"

namespace texbake {

enum class MaskKind {
  binary,  ///< 1 for one noise, 0 for the others: the nearest center, borders where both have half of the power
  soft,    ///< a convex barycenter that keeps relative distances
};
template <>
struct EnumNames<MaskKind> {
  static constexpr std::pair<MaskKind, std::string_view> values[] = {{MaskKind::binary, "binary"},
                                                                     {MaskKind::soft, "soft"}};
};

/// Masks are multiples of this and sum to 1 exactly: half floats hold them without error.
inline constexpr int kMaskSteps = 2048;

/// The weights, ≥ 0 and with a positive sum, as multiples of 1/kMaskSteps that sum to 1: by the largest remainder, the
/// lowest index first among equal ones.
void quantize_weights(std::span<const double> weights, std::span<float> quantized);

/// Throws Error(bad_data) unless the masks are of one size, ≥ 0, multiples of 1/kMaskSteps and sum to 1 at each texel.
void check_masks(std::span<const Image<float>> masks);

/// Centers of the `noises` clusters of the features, dark ones first (by the luminance of their color).
/// Throws Error(infeasible) when there are fewer distinct features.
Vectors cluster_grain(const GrainFeatures& features, int noises, uint32_t seed);

/// One plane for each center.
std::vector<Image<float>> assign_masks(const GrainFeatures& features, const Vectors& centers, MaskKind kind);

/// The mask of greatest weight at each texel, the lowest index among equal ones.
Image<uint8_t> strongest_mask(std::span<const Image<float>> masks);

/// For each mask, 1 at the `share` of the texels where it is strongest whose features are closest to their mean, else
/// 0. BL17 estimates a spectrum on 90 % of the cluster.
std::vector<Image<uint8_t>> cluster_cores(const GrainFeatures& features, std::span<const Image<float>> masks,
                                          double share);

}  // namespace texbake
