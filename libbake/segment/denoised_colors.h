// The colors by which fragments grow: classes and variation without the grain of the photograph.
#pragma once

#include "libbake/color/palette.h"

namespace texbake {

struct DenoisedColors {
  Image<V3f> luv;          ///< color of each texel, CIELUV
  Image<uint8_t> index;    ///< its class
  Image<float> variation;  ///< and coordinate along V_i
};

/// With `denoise_px` = 0 the classes and variations of `colors` as they are: the growth of the paper. Else the colors
/// D_i + v V_i are blurred by a Gaussian of that standard deviation on the torus, and each is given to the class whose
/// line it is nearest to (eq. 1; the lowest index among equals). Grain makes classes flicker from texel to texel; on
/// photographs, 1.5 px raise the contrast along the borders of the cleaned fragments by a tenth to a quarter.
DenoisedColors denoised_colors(const PrincipalVariation& colors, float denoise_px);

/// Median of |v|: half of a robust width of the classes.
float median_variation(const Image<float>& variation);

}  // namespace texbake
