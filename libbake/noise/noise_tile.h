// Realizations of a noise from its spectrum, on a lattice.
// Based on: Guingo et al. 2017, eq. 1 and §3.2: all noises share their phases, so that a blend of two keeps its power.
// Here the frequencies of eq. 1 are those of a lattice, and the sum is one transform of all values in a row.
#pragma once

#include <complex>
#include <cstdint>

#include "libbake/base/image.h"

namespace texbake {

/// exp(iφ_k) for k = 0 … count − 1, Hermitian: φ(−k) = −φ(k); ±1 where k = −k. A function of seed and channel alone.
/// `count` is even; count×1.
Image<std::complex<float>> random_phases(int count, uint32_t seed, int channel);

/// Value n is Σ_k S_k cos(2π k n / count + φ_k): mean 0 where S_0 = 0, variance Σ S² exactly. On a lattice
/// (noise_lattice.h) k is the frequency NoiseLattice::frequency(k). `spectrum` is count×1, S_k = S_−k; so is the
/// result.
Image<float> realise_noise(ImageView<const float> spectrum, ImageView<const std::complex<float>> phases);

}  // namespace texbake
