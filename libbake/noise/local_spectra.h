// The local spectrum at every texel: Welch's method on small windows of the luminance.
// Based on: Guingo et al. 2017, §3.3; Welch 1967.
//
// Around texel x all T×T segments whose origins lie in a (T+1)² box centered on x are windowed (Hann) and transformed;
//
//   S_x(f) = sqrt(mean over the segments of |FFT|²) / (Σ w)² / (10 · std of the luminance)
//
// so that distances mean the same for every exemplar. The luminance is real: S(f) = S(−f), and one bin stands for both.
#pragma once

#include <span>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Relative luminance of linear Rec.709 light.
Image<float> luminance(ImageView<const V3f> linear);

/// Standard deviation over all texels, summed in double by rows.
double standard_deviation(ImageView<const float> image);

/// The sizes T_loc of BL17.
inline constexpr int kLocalSizes[] = {2, 4, 8, 16};

/// One unique frequency of a T×T spectrum, in cycles per T texels.
struct SpectrumBin {
  int u = 0;       ///< 0 … T/2
  int v = 0;       ///< 0 … T−1
  int weight = 1;  ///< 2 where −f is another bin of the whole spectrum
};

/// Local spectra of some rows. A row of a bin runs from x = −kMargin to width + kMargin, on the torus.
class SpectraRows {
 public:
  static constexpr int kMargin = 8;

  SpectraRows(int y_begin, int y_end, int bins, int width);

  /// sqrt(weight) · S of one bin, so that the plain L2 norm over the unique bins is the norm over all T² bins.
  /// Element [x] is texel x; rows of consecutive bins are `stride()` floats apart.
  const float* row(int y, int bin) const { return data_.data() + offset(y, bin); }
  float* row(int y, int bin) { return data_.data() + offset(y, bin); }
  size_t stride() const { return stride_; }
  int y_begin() const { return y_begin_; }
  int y_end() const { return y_end_; }
  int bins() const { return bins_; }

 private:
  size_t offset(int y, int bin) const {
    return (static_cast<size_t>(y - y_begin_) * static_cast<size_t>(bins_) + static_cast<size_t>(bin)) * stride_ +
           kMargin;
  }
  int y_begin_;
  int y_end_;
  int bins_;
  size_t stride_;
  std::vector<float> data_;
};

/// Computes local spectra by rows, so that a large exemplar never has all of them in memory.
class LocalSpectra {
 public:
  /// `luminance` must outlive this object. Throws Error(usage) unless `local_size` is one of kLocalSizes,
  /// Error(infeasible) when the luminance is constant or a side is smaller than 2 · local_size.
  LocalSpectra(ImageView<const float> luminance, int local_size);
  LocalSpectra(Image<float>&& luminance, int local_size) = delete;

  /// The rows y_begin … y_end − 1 of the torus; they may lie outside 0 … height − 1.
  SpectraRows rows(int y_begin, int y_end) const;

  int local_size() const { return local_size_; }
  int width() const { return luminance_.width(); }
  int height() const { return luminance_.height(); }
  /// Unique frequencies, low ones first; T²/2 + 2 of them.
  std::span<const SpectrumBin> bins() const { return bins_; }
  double luminance_std() const { return luminance_std_; }

 private:
  ImageView<const float> luminance_;
  int local_size_;
  double luminance_std_;
  std::vector<SpectrumBin> bins_;
};

}  // namespace texbake
