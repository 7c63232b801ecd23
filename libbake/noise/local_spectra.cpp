// A band of rows at a time: Fourier along x by a direct sum, along y by a batched transform, then box means.
#include "libbake/noise/local_spectra.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "libbake/base/error.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/noise/batch_fft.h"

namespace texbake {
namespace {

/// Hann window of T texels, sampled half a texel inside, so that T = 2 is not degenerate and the window is symmetric.
double hann(int n, int size) {
  const double s = portable_sin(std::numbers::pi * (n + 0.5) / size);
  return s * s;
}

std::vector<SpectrumBin> unique_bins(int size) {
  std::vector<SpectrumBin> bins;
  for (int u = 0; u <= size / 2; ++u)
    for (int v = 0; v < size; ++v) {
      const bool own_mirror_u = u == 0 || u == size / 2;
      if (own_mirror_u && v > size / 2) continue;
      const bool own_mirror = own_mirror_u && (v == 0 || v == size / 2);
      bins.push_back({u, v, own_mirror ? 1 : 2});
    }
  // Low frequencies carry the largest differences: first, they let a distance be given up early.
  const auto squared_frequency = [size](const SpectrumBin& bin) {
    const int v = shortest(bin.v, size);
    return bin.u * bin.u + v * v;
  };
  std::stable_sort(bins.begin(), bins.end(), [&](const SpectrumBin& a, const SpectrumBin& b) {
    return squared_frequency(a) < squared_frequency(b);
  });
  return bins;
}

/// A band of planes whose rows run over segment origins x = −T … width, and y = y_begin − T … y_end.
struct OriginPlane {
  OriginPlane(int rows, int columns)
      : stride(static_cast<size_t>(round_to_lanes(columns))), data(static_cast<size_t>(rows) * stride) {}
  float* row(int j) { return data.data() + static_cast<size_t>(j) * stride; }
  const float* row(int j) const { return data.data() + static_cast<size_t>(j) * stride; }
  size_t stride;
  std::vector<float> data;
};

/// The band that is being computed, with its scratch memory.
template <int T>
class BandTransform {
 public:
  BandTransform(ImageView<const float> luminance, std::span<const SpectrumBin> bins, double scale, SpectraRows& out)
      : bins_(bins),
        scale_(scale),
        out_(out),
        width_(luminance.width()),
        origin_rows_(out.y_end() - out.y_begin() + T + 1),
        origin_columns_(width_ + T + 1),
        band_(origin_rows_ + T - 1, origin_columns_ + T + kLanes),
        re_(origin_rows_ + T - 1, origin_columns_),
        im_(origin_rows_ + T - 1, origin_columns_),
        power_(static_cast<size_t>(T), OriginPlane(origin_rows_, origin_columns_)) {
    for (int n = 0; n < T; ++n) window_[static_cast<size_t>(n)] = static_cast<float>(hann(n, T));
    for (int j = 0; j < origin_rows_ + T - 1; ++j) {
      const float* in = luminance.row(wrap(out.y_begin() - T + j, luminance.height()));
      for (int i = 0; i < origin_columns_ + T - 1; ++i) band_.row(j)[i] = in[wrap(i - T, width_)];
    }
  }

  void run() {
    for (int u = 0; u <= T / 2; ++u) {
      transform_rows(u);
      transform_columns();
      for (size_t b = 0; b < bins_.size(); ++b)
        if (bins_[b].u == u) average(static_cast<int>(b));
    }
    for (int y = out_.y_begin(); y < out_.y_end(); ++y)
      for (int b = 0; b < out_.bins(); ++b) wrap_margins(out_.row(y, b));
  }

 private:
  /// Windowed Fourier coefficient u along x of the T texels from each origin. The phase is taken from the middle of
  /// the segment, where sines and cosines are odd and even and half of the products are saved; powers do not see it.
  void transform_rows(int u) {
    std::array<float, T / 2> cosine;
    std::array<float, T / 2> sine;
    for (int n = 0; n < T / 2; ++n) {
      const double angle = 2.0 * std::numbers::pi * u * (n - (T - 1) * 0.5) / T;
      cosine[static_cast<size_t>(n)] = static_cast<float>(hann(n, T) * portable_cos(angle));
      sine[static_cast<size_t>(n)] = static_cast<float>(-hann(n, T) * portable_sin(angle));
    }
    for (int j = 0; j < origin_rows_ + T - 1; ++j) {
      const float* in = band_.row(j);
      for (int x = 0; x < origin_columns_; x += kLanes) {
        Lanes re{};
        Lanes im{};
        for (int n = 0; n < T / 2; ++n) {
          const Lanes left = load_lanes(in + x + n);
          const Lanes right = load_lanes(in + x + T - 1 - n);
          re += (left + right) * cosine[static_cast<size_t>(n)];
          im += (left - right) * sine[static_cast<size_t>(n)];
        }
        store_lanes(re_.row(j) + x, re);
        store_lanes(im_.row(j) + x, im);
      }
    }
  }

  /// |FFT|² of the T rows from each origin.
  void transform_columns() {
    std::array<Lanes, T> re;
    std::array<Lanes, T> im;
    for (int j = 0; j < origin_rows_; ++j)
      for (int x = 0; x < origin_columns_; x += kLanes) {
        for (int n = 0; n < T; ++n) {
          const auto i = static_cast<size_t>(n);
          re[i] = load_lanes(re_.row(j + n) + x) * window_[i];
          im[i] = load_lanes(im_.row(j + n) + x) * window_[i];
        }
        batch_fft<T>(re, im);
        for (size_t v = 0; v < T; ++v) store_lanes(power_[v].row(j) + x, re[v] * re[v] + im[v] * im[v]);
      }
  }

  /// Mean over the box of T + 1 origins, centered: its T + 2 taps along each axis are ½, 1, … 1, ½. Sums of T rows are
  /// made by doubling, which is exact in structure (no running sum that drifts).
  void average(int bin) {
    OriginPlane& plane = power_[static_cast<size_t>(bins_[static_cast<size_t>(bin)].v)];
    const int rows = out_.y_end() - out_.y_begin();
    sum_.resize(plane.data.size());
    box_along_y(plane, rows);
    const auto factor = static_cast<float>(scale_ * scale_ * bins_[static_cast<size_t>(bin)].weight /
                                           (static_cast<double>(T + 1) * (T + 1)));
    for (int j = 0; j < rows; ++j) box_along_x(plane.row(j), factor, out_.row(out_.y_begin() + j, bin));
  }

  /// Row j of the plane becomes Σ of rows j + 1 … j + T, plus half of rows j and j + T + 1.
  void box_along_y(OriginPlane& plane, int rows) {
    const int columns = round_to_lanes(origin_columns_);
    std::copy(plane.data.begin(), plane.data.end(), sum_.begin());
    for (int span = 1, count = origin_rows_; span < T; span *= 2) {
      count -= span;
      for (int j = 0; j < count; ++j) add_row(sum_.data() + j * plane.stride, sum_.data() + (j + span) * plane.stride);
    }
    for (int j = 0; j < rows; ++j) {
      float* ends = plane.row(j);
      const float* far_end = plane.row(j + T + 1);
      const float* inner = sum_.data() + (j + 1) * plane.stride;
      for (int x = 0; x < columns; ++x) ends[x] = (ends[x] + far_end[x]) * 0.5f + inner[x];
    }
  }
  void add_row(float* to, const float* from) const {
    for (int x = 0; x < round_to_lanes(origin_columns_); ++x) to[x] += from[x];
  }

  /// The same along x, then sqrt(factor · sum) for the `width` texels.
  void box_along_x(const float* in, float factor, float* out) {
    line_.assign(in, in + origin_columns_);
    for (int span = 1, count = origin_columns_; span < T; span *= 2) {
      count -= span;
      for (int x = 0; x < count; ++x) line_[static_cast<size_t>(x)] += line_[static_cast<size_t>(x + span)];
    }
    for (int x = 0; x < width_; ++x)
      out[x] = std::sqrt(((in[x] + in[x + T + 1]) * 0.5f + line_[static_cast<size_t>(x + 1)]) * factor);
  }

  void wrap_margins(float* row) const {
    for (int i = 1; i <= SpectraRows::kMargin; ++i) row[-i] = row[wrap(-i, width_)];
    for (int i = 0; i < SpectraRows::kMargin + kLanes; ++i) row[width_ + i] = row[wrap(i, width_)];
  }

  std::span<const SpectrumBin> bins_;
  double scale_;
  SpectraRows& out_;
  int width_;
  int origin_rows_;
  int origin_columns_;
  OriginPlane band_;
  OriginPlane re_;
  OriginPlane im_;
  std::vector<OriginPlane> power_;
  std::vector<float> sum_;
  std::vector<float> line_;
  std::array<float, T> window_;
};

template <int T>
void transform_band(ImageView<const float> luminance, std::span<const SpectrumBin> bins, double luminance_std,
                    SpectraRows& out) {
  double window_sum = 0.0;
  for (int n = 0; n < T; ++n) window_sum += hann(n, T);
  const double scale = 1.0 / (window_sum * window_sum) / (10.0 * luminance_std);
  BandTransform<T>(luminance, bins, scale, out).run();
}

}  // namespace

Image<float> luminance(ImageView<const V3f> linear) {
  Image<float> result(linear.width(), linear.height());
  for (size_t i = 0; i < linear.size(); ++i) {
    const V3f& c = linear.data()[i];
    result.data()[i] = 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
  }
  return result;
}

double standard_deviation(ImageView<const float> image) {
  double sum = 0.0;
  for (const float value : image) sum += value;
  const double mean = sum / static_cast<double>(image.size());
  double squares = 0.0;
  for (const float value : image) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(image.size()));
}

SpectraRows::SpectraRows(int y_begin, int y_end, int bins, int width)
    : y_begin_(y_begin),
      y_end_(y_end),
      bins_(bins),
      stride_(static_cast<size_t>(round_to_lanes(width + 2 * kMargin + kLanes))),
      data_(static_cast<size_t>(y_end - y_begin) * static_cast<size_t>(bins) * stride_) {}

LocalSpectra::LocalSpectra(ImageView<const float> luminance, int local_size)
    : luminance_(luminance), local_size_(local_size), luminance_std_(standard_deviation(luminance)) {
  if (std::find(std::begin(kLocalSizes), std::end(kLocalSizes), local_size) == std::end(kLocalSizes))
    throw Error(ErrorKind::usage, fmt::format("--local-size: expected 2, 4, 8 or 16 texels, found {}", local_size));
  if (std::min(luminance.width(), luminance.height()) < 2 * local_size)
    throw Error(
        ErrorKind::infeasible,
        fmt::format("local spectra of {0} x {0} texels need an exemplar of at least {1} x {1}, found {2} x {3}; "
                    "use a smaller --local-size",
                    local_size, 2 * local_size, luminance.width(), luminance.height()));
  if (!(luminance_std_ > 1e-6))
    throw Error(ErrorKind::infeasible, fmt::format("the luminance of the exemplar is constant (standard deviation "
                                                   "{:.2g}): there is no noise to separate; keep it as one layer",
                                                   luminance_std_));
  bins_ = unique_bins(local_size);
}

SpectraRows LocalSpectra::rows(int y_begin, int y_end) const {
  SpectraRows out(y_begin, y_end, static_cast<int>(bins_.size()), width());
  switch (local_size_) {
    case 2:
      transform_band<2>(luminance_, bins_, luminance_std_, out);
      break;
    case 4:
      transform_band<4>(luminance_, bins_, luminance_std_, out);
      break;
    case 8:
      transform_band<8>(luminance_, bins_, luminance_std_, out);
      break;
    default:
      transform_band<16>(luminance_, bins_, luminance_std_, out);
      break;
  }
  return out;
}

}  // namespace texbake
