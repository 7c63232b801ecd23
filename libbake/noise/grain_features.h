// What tells one noise from another at a texel: the logarithms of its local spectrum, and the color around it.
// Based on: Guingo et al. 2017, §3.3; logarithms because amplitudes would sort texels by brightness.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/noise/k_means.h"
#include "libbake/noise/local_spectra.h"

namespace texbake {

/// Computes feature vectors by rows. Dimension b < bins is sqrt(weight_b) · log(S_b + 0.1 · std / T), S and std of the
/// luminance; the last three are the color, smoothed over 3 px and scaled so that its total variance is `color_weight`
/// times that of the others.
class GrainFeatures {
 public:
  /// `exemplar` and `spectra` must outlive this object; `spectra` are those of the exemplar's luminance.
  GrainFeatures(ImageView<const V3f> exemplar, const LocalSpectra& spectra, double color_weight);

  int width() const { return color_.width(); }
  int height() const { return color_.height(); }
  int dimensions() const { return static_cast<int>(spectra_.bins().size()) + 3; }
  /// Rows y_begin … y_end − 1 inside the image; row(y, d)[x] is dimension d. Margins hold nothing.
  SpectraRows rows(int y_begin, int y_end) const;
  /// The vectors of the texels of a regular lattice that starts at texel (0, 0), by rows: neighboring spectra are
  /// nearly equal, a few thousand of them stand for all.
  const Vectors& samples() const { return samples_; }
  /// The texel of sample i.
  V2i sample_place(int i) const { return {i % columns_ * step_, i / columns_ * step_}; }
  /// Dimension d of a texel around which two noises of features a and b have half of the power each.
  double mixture(int d, float a, float b) const;
  /// The luminance of a feature vector's color, up to a common factor.
  double luminance_of(const float* features) const;

 private:
  Vectors take_samples() const;
  /// Of the samples, the sum of the variances of dimensions begin … end − 1.
  double total_variance(int begin, int end) const;

  const LocalSpectra& spectra_;
  Image<V3f> color_;
  float color_scale_ = 1.0f;
  int step_ = 1;
  int columns_ = 0;
  Vectors samples_;
};

}  // namespace texbake
