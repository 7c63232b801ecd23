// Features are recomputed where they are needed: that is cheaper than keeping up to 133 planes.
#include "libbake/noise/grain_features.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/noise/lanes.h"

namespace texbake {
namespace {

constexpr double kColorSmoothing = 3.0;  // px
constexpr int kMostSamples = 16384;

/// The smallest step of a lattice over the image that has at most `most` texels.
int lattice_step(int width, int height, int64_t most) {
  int step = 1;
  while (static_cast<int64_t>((width + step - 1) / step) * ((height + step - 1) / step) > most) ++step;
  return step;
}

}  // namespace

GrainFeatures::GrainFeatures(ImageView<const V3f> exemplar, const LocalSpectra& spectra, double color_weight)
    : spectra_(spectra),
      color_(gaussian_blur(exemplar, kColorSmoothing, Wrap::repeat)),
      step_(lattice_step(exemplar.width(), exemplar.height(), kMostSamples)),
      columns_((exemplar.width() + step_ - 1) / step_),
      samples_(take_samples()) {
  const int bins = dimensions() - 3;
  const double of_color = total_variance(bins, bins + 3);
  const double of_spectra = total_variance(0, bins);
  color_scale_ = of_color > 0.0 ? static_cast<float>(std::sqrt(color_weight * of_spectra / of_color)) : 0.0f;
  for (int i = 0; i < samples_.count(); ++i)
    for (int c = 0; c < 3; ++c) samples_.row(i)[bins + c] *= color_scale_;
}

SpectraRows GrainFeatures::rows(int y_begin, int y_end) const {
  const SpectraRows spectra = spectra_.rows(y_begin, y_end);
  SpectraRows features(y_begin, y_end, dimensions(), spectra_.width());
  // S is stored in units of 10 standard deviations: log(S + 0.1 std/T) = log(10 s + 0.1/T) + log std.
  const float floor = 0.1f / static_cast<float>(spectra_.local_size());
  const int width = spectra_.width();
  for (int y = y_begin; y < y_end; ++y) {
    for (int b = 0; b < spectra.bins(); ++b) {
      const bool twice = spectra_.bins()[static_cast<size_t>(b)].weight == 2;
      const float amplitude = twice ? 7.07106781f : 10.0f;
      const float weight = twice ? 1.41421356f : 1.0f;
      const float* in = spectra.row(y, b);
      float* out = features.row(y, b);
      for (int x = 0; x < width; x += kLanes)
        store_lanes(out + x, log_lanes(load_lanes(in + x) * amplitude + splat(floor)) * weight);
    }
    for (int c = 0; c < 3; ++c) {
      float* out = features.row(y, spectra.bins() + c);
      for (int x = 0; x < width; ++x) out[x] = color_(x, y)[c] * color_scale_;
    }
  }
  return features;
}

Vectors GrainFeatures::take_samples() const {
  const int lattice_rows = (height() + step_ - 1) / step_;
  Vectors samples(columns_ * lattice_rows, dimensions());
  constexpr int kRowsTogether = 32;  // the spectra of a band share their sums
  const int band_rows = std::max(1, kRowsTogether / step_);
  parallel_for(0, (lattice_rows + band_rows - 1) / band_rows, [&](int band) {
    const int begin = band * band_rows;
    const int end = std::min(begin + band_rows, lattice_rows);
    const SpectraRows features = rows(begin * step_, (end - 1) * step_ + 1);
    for (int j = begin; j < end; ++j)
      for (int i = 0; i < columns_; ++i)
        for (int d = 0; d < dimensions(); ++d) samples.row(j * columns_ + i)[d] = features.row(j * step_, d)[i * step_];
  });
  return samples;
}

double GrainFeatures::mixture(int d, float a, float b) const {
  if (d >= dimensions() - 3) return 0.5 * (static_cast<double>(a) + static_cast<double>(b));
  const double weight = spectra_.bins()[static_cast<size_t>(d)].weight == 2 ? 1.41421356237309504880 : 1.0;
  const double floor = 0.1 / spectra_.local_size();
  const double amplitude_a = portable_exp(static_cast<double>(a) / weight) - floor;
  const double amplitude_b = portable_exp(static_cast<double>(b) / weight) - floor;
  return weight * portable_log(std::sqrt(0.5 * (amplitude_a * amplitude_a + amplitude_b * amplitude_b)) + floor);
}

double GrainFeatures::luminance_of(const float* features) const {
  const float* color = features + dimensions() - 3;
  return 0.2126 * static_cast<double>(color[0]) + 0.7152 * static_cast<double>(color[1]) +
         0.0722 * static_cast<double>(color[2]);
}

double GrainFeatures::total_variance(int begin, int end) const {
  double total = 0.0;
  for (int d = begin; d < end; ++d) {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < samples_.count(); ++i) {
      const auto value = static_cast<double>(samples_.row(i)[d]);
      sum += value;
      squares += value * value;
    }
    const double mean = sum / samples_.count();
    total += std::max(0.0, squares / samples_.count() - mean * mean);
  }
  return total;
}

}  // namespace texbake
