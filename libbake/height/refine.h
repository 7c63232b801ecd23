// Smooths propagated heights along the surface, and keeps the edges that its colors show.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// The heights h that minimize
///
///   Σ_p (h_p − propagated_p)² + strength · Σ_pq w_pq · (h_p − h_q)²
///
/// over texels p and pairs of 4-neighbors p, q on the torus. w_pq = exp(−‖C_p − C_q‖ / 1 ΔE), where C is `luv`,
/// smoothed by 1 px: about 1 on an even surface, nothing across an edge. `strength` ≥ 0; 0 changes nothing, and a flat
/// height stays flat. Found by conjugate gradients, in a fixed order and number of steps.
Image<float> refine(ImageView<const float> propagated, ImageView<const V3f> luv, float strength);

}  // namespace texbake
