// Periodic realisations of a noise from its spectrum.
// Based on: Guingo et al. 2017, eq. 1 and §3.2: all noises share their phases, so that a blend of two keeps its power.
#pragma once

#include <complex>
#include <cstdint>

#include "libbake/base/image.h"

namespace texbake {

/// exp(iφ(f)) for size×size frequencies, Hermitian: φ(−f) = −φ(f); ±1 where f = −f. A function of seed and channel
/// alone. `size` is even.
Image<std::complex<float>> random_phases(int size, uint32_t seed, int channel);

/// Σ_f S(f) cos(2π f·x / size + φ(f)): periodic, mean 0 where S(0) = 0, variance Σ S² exactly. `spectrum` has the size
/// of `phases` and S(f) = S(−f).
Image<float> realise_noise(ImageView<const float> spectrum, ImageView<const std::complex<float>> phases);

}  // namespace texbake
