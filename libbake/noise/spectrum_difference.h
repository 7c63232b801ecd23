// How different two spectra look, in decibels.
#pragma once

#include "libbake/base/image.h"
#include "libbake/noise/noise_lattice.h"

namespace texbake {

/// Root mean square over 10 radial × 8 angular bins of 10 log10(power of a / power of b). Tables of magnitudes as in
/// spectrum.h, of one size. Bins in which `b` has less than 10⁻⁴ of the power of its strongest bin do not count: what
/// is 40 dB below is neither seen nor estimated. 0 for two zero spectra, infinity when only one is zero.
double spectrum_difference_db(ImageView<const float> a, ImageView<const float> b);
/// The same of magnitudes at the frequencies of a lattice, count×1.
double spectrum_difference_db(ImageView<const float> a, ImageView<const float> b, const NoiseLattice& lattice);

}  // namespace texbake
