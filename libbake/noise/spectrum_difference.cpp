#include "libbake/noise/spectrum_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "libbake/base/portable_math.h"
#include "libbake/base/torus.h"

namespace texbake {
namespace {

constexpr int kRadii = 10;
constexpr int kAngles = 8;
constexpr double kNegligible = 1e-4;
using Bins = std::array<double, kRadii * kAngles>;

/// Of the half plane y ≥ 0: which eighth of the half turn, by slopes that are multiples of π/8.
int angle_idx(double x, double y) {
  constexpr double kTan = 0.41421356237309504880;  // tan(π/8)
  const double steep = std::fabs(x) < y ? std::fabs(x) / y : y / std::fabs(x);
  const int within = steep < kTan ? 0 : 1;
  const int from_x_axis = std::fabs(x) < y ? 3 - within : within;
  return x >= 0.0 ? from_x_axis : 7 - from_x_axis;
}

/// Adds the power of a frequency in cycles per texel.
void add_power(Imath::V2d f, float magnitude, Bins& bins) {
  if (f.x == 0.0 && f.y == 0.0) return;
  if (f.y < 0.0) f = -f;
  const int radius = static_cast<int>(std::sqrt(f.x * f.x + f.y * f.y) / 0.5 * kRadii);
  if (radius >= kRadii) return;
  bins[static_cast<size_t>(radius * kAngles + angle_idx(f.x, f.y))] +=
      static_cast<double>(magnitude) * static_cast<double>(magnitude);
}

Bins binned_power(ImageView<const float> spectrum) {
  Bins bins = {};
  const int size = spectrum.width();
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      add_power(Imath::V2d(shortest(x, size), shortest(y, size)) / size, spectrum(x, y), bins);
  return bins;
}

Bins binned_power(ImageView<const float> spectrum, const NoiseLattice& lattice) {
  Bins bins = {};
  for (int k = 0; k < lattice.count; ++k) add_power(lattice.frequency(k), spectrum(k, 0), bins);
  return bins;
}

double difference_db(const Bins& power_a, const Bins& power_b) {
  const double strongest = *std::max_element(power_b.begin(), power_b.end());
  double squares = 0.0;
  int count = 0;
  for (size_t i = 0; i < power_a.size(); ++i) {
    if (!(power_b[i] > kNegligible * strongest)) continue;
    if (!(power_a[i] > 0.0)) return std::numeric_limits<double>::infinity();
    const double db = 10.0 / 2.30258509299404568402 * portable_log(power_a[i] / power_b[i]);
    squares += db * db;
    ++count;
  }
  if (count > 0) return std::sqrt(squares / count);
  return *std::max_element(power_a.begin(), power_a.end()) > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace

double spectrum_difference_db(ImageView<const float> a, ImageView<const float> b) {
  return difference_db(binned_power(a), binned_power(b));
}

double spectrum_difference_db(ImageView<const float> a, ImageView<const float> b, const NoiseLattice& lattice) {
  return difference_db(binned_power(a, lattice), binned_power(b, lattice));
}

}  // namespace texbake
