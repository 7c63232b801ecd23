// Does an exemplar whose noise was made again still look like itself? Two numbers that say what kurtosis does not:
// noise of the wrong strength in the wrong place, and structure that was left in the noise. Based on: Guingo et al.
// 2017, §5 (Fig. 14: the choice a user makes by eye) and §7 (Fig. 17: noise that is not Gaussian).
#pragma once

#include "libbake/base/image.h"

namespace texbake {

/// Standard deviation over the texels of E(a) − E(b), E(X) = log of the summed squared Laplacian bands of X
/// (differences of Gaussians of σ = 0, 1, 2, 4 … 32 px) smoothed by 6 px. Two images of luminance, on the torus.
double energy_deviation(ImageView<const float> a, ImageView<const float> b);

/// Mean coherence (λ₁ − λ₂)/(λ₁ + λ₂) of the structure tensor (smoothed by 2 px) over all texels: 0 for grain
/// without direction, 1 for lines and edges.
double mean_coherence(ImageView<const float> luminance);

}  // namespace texbake
