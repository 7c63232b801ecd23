// Quantiles are read from a fine histogram: no sort, and exact to a 16384th of the range.
#include "libbake/noise/equalization.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

constexpr int kBins = 16384;

double density(double g) { return 0.39894228040143267794 * portable_exp(-0.5 * g * g); }

}  // namespace

float Equalization::operator()(double g) const {
  const double place = std::clamp((g / kRange + 1.0) * 0.5, 0.0, 1.0) * (kEntries - 1);
  const auto i = std::min(static_cast<size_t>(place), static_cast<size_t>(kEntries - 2));
  const auto part = static_cast<float>(place - static_cast<double>(i));
  return values[i] + (values[i + 1] - values[i]) * part;
}

const std::vector<double>& normal_cumulative() {
  // Simpson's rule from 0 outwards: Φ(−g) = 1 − Φ(g).
  static const std::vector<double> table = [] {
    std::vector<double> cumulative(Equalization::kEntries, 0.5);
    const double step = 2.0 * Equalization::kRange / (Equalization::kEntries - 1);
    constexpr int kMiddle = Equalization::kEntries / 2;
    for (int i = 1; i <= kMiddle; ++i) {
      const double g = (i - 1) * step;
      const double area = step / 6.0 * (density(g) + 4.0 * density(g + step / 2.0) + density(g + step));
      const auto right = static_cast<size_t>(kMiddle + i);
      cumulative[right] = cumulative[right - 1] + area;
      cumulative[static_cast<size_t>(kMiddle - i)] = 1.0 - cumulative[right];
    }
    return cumulative;
  }();
  return table;
}

Equalization match_histogram(ImageView<const float> channel, ImageView<const uint8_t> mask, double center) {
  Equalization transfer{std::vector<float>(Equalization::kEntries)};
  double least = INFINITY;
  double most = -INFINITY;
  int64_t count = 0;
  for (size_t i = 0; i < channel.size(); ++i) {
    if (mask.data()[i] == 0) continue;
    least = std::min(least, static_cast<double>(channel.data()[i]));
    most = std::max(most, static_cast<double>(channel.data()[i]));
    ++count;
  }
  if (count == 0 || !(most > least)) return transfer;

  std::vector<int64_t> histogram(kBins);
  const double scale = kBins / (most - least);
  for (size_t i = 0; i < channel.size(); ++i)
    if (mask.data()[i] != 0)
      ++histogram[std::min(static_cast<size_t>((static_cast<double>(channel.data()[i]) - least) * scale),
                           static_cast<size_t>(kBins - 1))];

  // The bin in which the cumulated count passes Φ(g), and the place inside it.
  size_t bin = 0;
  double before = 0.0;
  for (size_t entry = 0; entry < transfer.values.size(); ++entry) {
    const double rank = normal_cumulative()[entry] * static_cast<double>(count);
    while (bin + 1 < kBins && before + static_cast<double>(histogram[bin]) < rank)
      before += static_cast<double>(histogram[bin++]);
    const double part =
        histogram[bin] > 0 ? std::clamp((rank - before) / static_cast<double>(histogram[bin]), 0.0, 1.0) : 0.0;
    transfer.values[entry] = static_cast<float>(least + (static_cast<double>(bin) + part) / scale - center);
  }
  return transfer;
}

}  // namespace texbake
