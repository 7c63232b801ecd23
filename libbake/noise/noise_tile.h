// Periodic realisations of a noise from its spectrum, and their levels of detail.
// Based on: Guingo et al. 2017, eq. 1 and §3.2: all noises share their phases, so that a blend of two keeps its power.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// exp(iφ(f)) for size×size frequencies, Hermitian: φ(−f) = −φ(f); ±1 where f = −f. A function of seed and channel
/// alone. `size` is even.
Image<std::complex<float>> random_phases(int size, uint32_t seed, int channel);

/// Σ_f S(f) cos(2π f·x / size + φ(f)): periodic, mean 0 where S(0) = 0, variance Σ S² exactly. `spectrum` has the size
/// of `phases` and S(f) = S(−f).
Image<float> realise_noise(ImageView<const float> spectrum, ImageView<const std::complex<float>> phases);

/// The levels of detail 0 … levels − 1 of a periodic power-of-two tile; level l has 1/2^l of its size. Level l is what
/// the means over 2^l × 2^l texels would be, without the frequencies that a grid of that spacing cannot carry: they
/// fade instead of turning into other ones. Level 0 is the tile. Not rounded to half.
std::vector<Image<V3f>> noise_levels(ImageView<const V3f> tile, int levels);

/// |transfer|² of level l at a frequency (cycles per texel of level 0): the fading of `noise_levels`.
double level_transfer_power(double fx_cpp, double fy_cpp, int level);

}  // namespace texbake
