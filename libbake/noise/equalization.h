// Gives a Gaussian noise the histogram of the noise it stands for, channel by channel.
// Based on: Guingo et al. 2017, §6 and Fig. 15.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/base/image.h"

namespace texbake {

/// A monotone transfer: `values[i]` is what a Gaussian value of g = (i / (n − 1) − ½) · 2 · kRange standard deviations
/// becomes; linear between, constant beyond.
struct Equalization {
  static constexpr double kRange = 4.0;  ///< standard deviations; 6 texels in 100000 lie beyond
  static constexpr int kEntries = 257;
  std::vector<float> values;

  float operator()(double g) const;
};

/// The transfer whose result has the distribution of `channel` where `mask` is not 0, about the mean `center`: its
/// value at g is the quantile of the normal distribution's Φ(g), minus `center`. Without a texel it is 0.
Equalization match_histogram(ImageView<const float> channel, ImageView<const uint8_t> mask, double center);

/// Φ at the entries of an Equalization, rising.
const std::vector<double>& normal_cumulative();

}  // namespace texbake
