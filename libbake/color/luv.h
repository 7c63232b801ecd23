// CIELUV under D65 from linear Rec.709 light, and the sRGB curve. Based on: CIE 15:2004; IEC 61966-2-1.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// (L, u*, v*) of a linear Rec.709 color; L is 100 for (1, 1, 1). Black gives (0, 0, 0). Negative and > 1 values are
/// carried through where the formula allows, so that the pair of functions round-trips: for real colors to 1e-5 of the
/// largest channel, for colors outside Rec.709 as long as v' ≥ 1/64 (the spectral locus ends at 0.0166).
V3f luv_from_linear(const V3f& linear);
V3f linear_from_luv(const V3f& luv);
Image<V3f> luv_from_linear(ImageView<const V3f> linear);
Image<V3f> linear_from_luv(ImageView<const V3f> luv);

/// The exact piecewise sRGB curve on one channel; identity-preserving at 0 and 1, odd for negative values.
/// `linear_from_srgb` costs a general power: tabulate it for 8- and 16-bit input.
float linear_from_srgb(float encoded);
float srgb_from_linear(float linear);

}  // namespace texbake
