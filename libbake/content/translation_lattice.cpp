#include "libbake/content/translation_lattice.h"

#include <algorithm>
#include <complex>
#include <cstdint>
#include <cstdlib>

#include "libbake/base/fft.h"
#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr double kHighPassDivisor = 16;  // of the shorter side
constexpr double kLeastPeak = 0.15;
constexpr double kPeakShare = 0.4;
constexpr double kStrongShare = 0.8;
constexpr size_t kLeastPeaks = 6;  // a peak and its mirror are two
constexpr int kPeakRadius = 4;  // a peak is the greatest value this far around; at least twice this from the identity

struct Peak {
  double value = 0;
  V2i translation{0, 0};
};

// Autocorrelation of the high-passed tile over all translations, 1 at the identity; all 0 for a constant.
Image<double> autocorrelation(ImageView<const V3f> luv) {
  const double sigma_px = std::min(luv.width(), luv.height()) / kHighPassDivisor;
  const Image<V3f> low = gaussian_blur(luv, sigma_px, Wrap::repeat);
  Image<std::complex<double>> power(luv.width(), luv.height());
  for (int channel = 0; channel < 3; ++channel) {
    Image<double> high(luv.width(), luv.height());
    for (size_t i = 0; i < high.size(); ++i)
      high.data()[i] = static_cast<double>(luv.data()[i][channel]) - static_cast<double>(low.data()[i][channel]);
    const Image<std::complex<double>> spectrum = fft<double>(high.view());
    for (size_t i = 0; i < power.size(); ++i) power.data()[i] += std::norm(spectrum.data()[i]);
  }
  Image<double> correlation = inverse_fft_real<double>(power.view());
  const double variance = correlation(0, 0);
  for (double& value : correlation) value = variance > 1e-9 ? value / variance : 0.0;
  return correlation;
}

bool is_peak(ImageView<const double> correlation, V2i p) {
  const V2i size(correlation.width(), correlation.height());
  const double value = correlation(p.x, p.y);
  for (int dy = -kPeakRadius; dy <= kPeakRadius; ++dy)
    for (int dx = -kPeakRadius; dx <= kPeakRadius; ++dx) {
      const V2i q = wrap(p + V2i(dx, dy), size);
      if (q != p && correlation(q.x, q.y) >= value) return false;
    }
  return true;
}

std::vector<Peak> peaks_above(ImageView<const double> correlation, double least) {
  const V2i size(correlation.width(), correlation.height());
  std::vector<Peak> peaks;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const V2i t = shortest(V2i(x, y), size);
      if (correlation(x, y) < least || std::max(std::abs(t.x), std::abs(t.y)) < 2 * kPeakRadius) continue;
      if (is_peak(correlation, {x, y})) peaks.push_back({correlation(x, y), t});
    }
  std::stable_sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.value > b.value; });
  return peaks;
}

int64_t squared_length(V2i t) { return int64_t{t.x} * t.x + int64_t{t.y} * t.y; }

// Whether two translations point in directions more than about 17 degrees apart.
bool spans(V2i a, V2i b) {
  const auto cross = static_cast<double>(int64_t{a.x} * b.y - int64_t{a.y} * b.x);
  return cross * cross > 0.09 * static_cast<double>(squared_length(a)) * static_cast<double>(squared_length(b));
}

// The shortest of the strongest peaks (first of `peaks`, by falling value) that `fits`; the identity where none does.
template <class Fits>
V2i shortest_of_strongest(const std::vector<Peak>& peaks, const Fits& fits) {
  V2i found(0, 0);
  double strongest = 0.0;
  for (const Peak& peak : peaks) {
    if (!fits(peak.translation) || peak.value < kStrongShare * strongest) continue;
    strongest = std::max(strongest, peak.value);
    if (found == V2i(0, 0) || squared_length(peak.translation) < squared_length(found)) found = peak.translation;
  }
  return found;
}

// The peaks that steps of ±a and ±b lead to from the identity, each step to a peak at most kPeakRadius off: real
// patterns drift.
std::vector<V2i> reached_peaks(const std::vector<Peak>& peaks, V2i a, V2i b, V2i size) {
  std::vector<uint8_t> taken(peaks.size());
  std::vector<V2i> reached{V2i(0, 0)};
  for (size_t next = 0; next < reached.size(); ++next)
    for (const V2i& step : {a, -a, b, -b})
      for (size_t i = 0; i < peaks.size(); ++i) {
        const V2i off = shortest(peaks[i].translation - reached[next] - step, size);
        if (taken[i] || std::max(std::abs(off.x), std::abs(off.y)) > kPeakRadius) continue;
        taken[i] = 1;
        reached.push_back(peaks[i].translation);
      }
  std::vector<V2i> translations;
  for (size_t i = 0; i < peaks.size(); ++i)
    if (taken[i]) translations.push_back(peaks[i].translation);
  return translations;
}

}  // namespace

std::optional<TranslationLattice> find_lattice(ImageView<const V3f> luv) {
  if (std::min(luv.width(), luv.height()) < 8 * kPeakRadius) return std::nullopt;
  const Image<double> correlation = autocorrelation(luv);
  std::vector<Peak> peaks = peaks_above(correlation, kLeastPeak);
  if (peaks.empty()) return std::nullopt;

  // Two short steps between strong peaks, and all peaks that they lead to.
  peaks = peaks_above(correlation, kPeakShare * peaks.front().value);
  const V2i a = shortest_of_strongest(peaks, [](V2i) { return true; });
  const V2i b = shortest_of_strongest(peaks, [&](V2i t) { return spans(a, t); });
  TranslationLattice lattice;
  lattice.correlation = peaks.front().value;
  lattice.translations = reached_peaks(peaks, a, b, {luv.width(), luv.height()});
  if (b == V2i(0, 0) || lattice.translations.size() < kLeastPeaks) return std::nullopt;
  return lattice;
}

Image<uint8_t> near_lattice(const TranslationLattice& lattice, V2i size, int radius_px) {
  Image<uint8_t> near(size.x, size.y);
  for (const V2i& translation : lattice.translations)
    for (int dy = -radius_px; dy <= radius_px; ++dy)
      for (int dx = -radius_px; dx <= radius_px; ++dx) {
        const V2i t = wrap(translation + V2i(dx, dy), size);
        near(t.x, t.y) = 1;
      }
  return near;
}

}  // namespace texbake
