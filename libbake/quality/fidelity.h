// How close a rendering is to its exemplar: colors, spectrum, sharpness, structure, and the amplitude of octave bands.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// F_color: sqrt of the mean over 64 directions of the squared Wasserstein-2 distance of the projected colors,
/// divided by the exemplar's standard deviation. Nothing for an exemplar of constant color.
std::optional<double> color_distance(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv);

/// F_psd: root mean square over 10 radial × 8 angular bins of 10 log10(P_rendering / P_exemplar), in dB. The spectra
/// are means over Hann-windowed squares of half the exemplar's smaller side, at half overlap on the torus, of the three
/// coordinates together. Nothing when that side is below 16 texels, the rendering is smaller than the exemplar, or the
/// exemplar has no power.
std::optional<double> spectrum_distance_db(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv);

struct GradientMatch {
  double quantile_distance = 0;  ///< mean |quantile difference| of gradient magnitudes / the exemplar's mean
  double ratio_of_means = 1;     ///< below 1: blur
};
std::optional<GradientMatch> gradient_match(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv);

/// F_structure: median distance of 400 8 × 8 windows of the rendering to their nearest window of the exemplar, divided
/// by the same for `periodic_luv`, the exemplar repeated. Exemplar windows stand at every fourth texel (eighth of
/// 1024), so that a copy is near but seldom at distance 0, and both renderings are treated alike. `seed` picks the
/// windows. Nothing when the latter distance is 0 (a constant exemplar) or a picture is smaller than a window.
std::optional<double> structure_distance(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv,
                                         ImageView<const V3f> periodic_luv, uint32_t seed = 1);

/// Amplitude (standard deviation) of each octave band of the rendering divided by the exemplar's: differences of
/// Gaussians at σ = n/128, n/64, … n/8 (n the exemplar's smaller side), finest first, then what is coarser than n/8.
/// A band without power in the exemplar is nothing. The rendering's sides are multiples of the exemplar's.
std::vector<std::optional<double>> octave_band_ratios(ImageView<const V3f> exemplar_luv,
                                                      ImageView<const V3f> rendering_luv);

}  // namespace texbake
