// Extracts the structure layer: a joint bilateral filter that averages texels whose local spectra are alike.
// Based on: Guingo et al. 2017, §5; Paris et al. 2009.
//
//   P_{i+1}(x) = Σ_δ w(x, x + δ) P_i(x + δ) / Σ_δ w,   w = exp(−‖S_x − S_{x+δ}‖² / 2σ²),   δ ∈ {−8 … 7}²
//
// from P_0 = the exemplar; the spectra guide and stay fixed.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/progress.h"
#include "libbake/base/torus.h"
#include "libbake/noise/local_spectra.h"

namespace texbake {

inline constexpr int kFilterBegin = -8;  ///< δ runs over kFilterBegin … kFilterEnd along both axes: 16 texels
inline constexpr int kFilterEnd = 7;

struct StructureParameters {
  double sigma = 0.01;  ///< of the distance between spectra, in units of 10 standard deviations of the luminance
  int iterations = 5;
};

/// The filtered `image`, which is a torus of the size of `guide`. Weights are kept in 16 bits (relative to the weight 1
/// of the texel itself): 286 bytes per texel while the filter runs.
Image<V3f> extract_structure(ImageView<const V3f> image, const LocalSpectra& guide,
                             const StructureParameters& parameters = {}, const Progress& progress = {});

}  // namespace texbake
