// The spectrum of a noise that is known only inside a mask, from its autocovariance over pairs of texels in the mask.
// Based on: Guingo et al. 2017, §3.3, eq. 3-5.
//
// A spectrum is an image of T×T magnitudes S; pixel (x, y) is the frequency of x and y cycles per T texels, so that
// S(x, y) = S(−x, −y) on the torus. S(0, 0) = 0 and Σ S² is the variance of the noise.
#pragma once

#include <cstdint>

#include "libbake/base/image.h"
#include "libbake/base/options.h"
#include "libbake/noise/noise_lattice.h"

namespace texbake {

enum class SpectrumEstimator {
  autocovariance,  ///< one autocovariance over the whole tile, each lag over its own pairs, under a lag window
  windows,         ///< the paper's: T×T windows that pave the tile, those with 70 % of their texels inside the mask
};
template <>
struct EnumNames<SpectrumEstimator> {
  static constexpr std::pair<SpectrumEstimator, std::string_view> values[] = {
      {SpectrumEstimator::autocovariance, "autocovariance"}, {SpectrumEstimator::windows, "windows"}};
};

/// Estimates spectra inside one mask (1 = known). The noise is a torus of the size of the mask.
class MaskedSpectrum {
 public:
  static constexpr int kSmallestSize = 4;

  /// `size` is the greatest T, a power of two ≥ 4. It is halved while the mask is too small to support it: T needs
  /// 4 T² texels in the mask, 64 pairs at every lag below T/2, and the exemplar must be T texels wide and high.
  /// Throws Error(infeasible) when no T ≥ 4 is supported.
  MaskedSpectrum(ImageView<const uint8_t> mask, int size, SpectrumEstimator estimator);

  int size() const { return size_; }
  /// The texels in the mask.
  int64_t count() const { return count_; }
  /// Share of the mask's texels that the estimator used: below 1 for `windows`. When no window has 70 % of its texels
  /// in the mask, all windows are used, and this is 1.
  double used_share() const { return used_share_; }

  /// Magnitudes, T×T. The mean inside the mask is taken out first.
  Image<float> estimate(ImageView<const float> noise) const;

 private:
  bool supports(int size) const;
  Image<double> autocovariance_power(ImageView<const float> centerd) const;
  Image<double> windows_power(ImageView<const float> centerd) const;
  void choose_windows();

  ImageView<const uint8_t> mask_;
  SpectrumEstimator estimator_;
  int size_;
  int64_t count_ = 0;
  double used_share_ = 1.0;
  double least_coverage_ = 0.7;
  Image<float> pairs_;  ///< pairs of texels in the mask at each lag
};

/// Mean of `image` over the texels where `mask` is not 0.
double masked_mean(ImageView<const float> image, ImageView<const uint8_t> mask);

/// Σ S².
double spectrum_power(ImageView<const float> spectrum);

/// The magnitudes of a periodic realization itself, without its mean: Σ S² is its variance.
Image<float> periodogram(ImageView<const float> tile);

/// The same noise at the frequencies of a lattice, count×1: the autocovariance continues with zeros. Σ S² is kept.
/// No value of the lattice returns within 1.5 T texels.
Image<float> lattice_spectrum(ImageView<const float> spectrum, const NoiseLattice& lattice);

}  // namespace texbake
