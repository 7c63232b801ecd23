// The compact spectrum: a noise's power as a few Gaussian lobes, which any Gaussian footprint filters in closed form.
// Based on: Guingo et al. 2017, §6 (filtering in the spectral domain); Galerne et al. 2012 (Gabor noise by example).
#pragma once

#include <span>
#include <vector>

#include "libbake/base/image.h"

namespace texbake {

/// A pair of Gaussians in the plane of frequencies (cycles per texel), one at +center and one at −center, that together
/// hold `power`: density(f) = power/2 · (g(f − center) + g(f + center)), g the normal density whose precision matrix is
/// LᵀL, L = (l_xx l_xy; 0 l_yy), in texels.
struct Lobe {
  double power = 0;
  double center_x_cpp = 0;  ///< 0 … ½
  double center_y_cpp = 0;  ///< −½ … ½
  double l_xx = 1;
  double l_xy = 0;
  double l_yy = 1;

  double density(double fx_cpp, double fy_cpp) const;
};

struct LobeFit {
  std::vector<Lobe> lobes;
  double error = 0;  ///< ‖S_lobes − S‖ / ‖S‖ over the table of magnitudes
};

/// Fits up to `most` lobes to a table of magnitudes (see spectrum.h), bounded, from several fixed starts; the best one
/// wins, the first of equal ones. Fields are rounded to 20 significant bits, so that the last bits of the C library's
/// functions inside the solver do not reach a bundle. A zero spectrum has no lobes and error 0. One thread.
LobeFit fit_lobes(ImageView<const float> spectrum, int most);

/// Magnitudes of the lobes on T×T frequencies, S = sqrt(density / T²), S(0) = 0. Not scaled to any power: the density
/// beyond ½ cycle per texel is not in the table.
Image<float> lobe_spectrum(std::span<const Lobe> lobes, int size);

/// The variance that is left under a Gaussian footprint of covariance (xx, xy, yy), in texels²:
/// ∫ density(f) · exp(−4π² fᵀ C f) df, in closed form. C = 0 gives the sum of the powers.
double filtered_variance(std::span<const Lobe> lobes, double xx, double xy, double yy);

}  // namespace texbake
