#include "libbake/noise/lobe_cost.h"

#include <cmath>

#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

constexpr double kInverse2Pi = 0.15915494309189533577;

/// density = scale · exp(−½(a² + b²)), a = l_xx dx + l_xy dy, b = l_yy dy. Adds its derivatives by (power, center, L),
/// the distance from the center being d = f − sign · center, to `gradient`, when there is one.
double half_lobe(const LobeSample& sample, const double* p, double sign, double* gradient) {
  const double dx = sample.fx_cpp - sign * p[1];
  const double dy = sample.fy_cpp - sign * p[2];
  const double a = p[3] * dx + p[4] * dy;
  const double b = p[5] * dy;
  const double exponent = 0.5 * (a * a + b * b);
  if (exponent > 60.0) return 0.0;
  const double unit = 0.5 * kInverse2Pi * p[3] * p[5] * portable_exp(-exponent);  // of power 1
  const double density = p[0] * unit;
  if (gradient != nullptr) {
    gradient[0] += unit;
    gradient[1] += density * sign * a * p[3];
    gradient[2] += density * sign * (a * p[4] + b * p[5]);
    gradient[3] += density * (1.0 / p[3] - a * dx);
    gradient[4] += density * (-a * dy);
    gradient[5] += density * (1.0 / p[5] - b * dy);
  }
  return density;
}

}  // namespace

void lobe_residuals(const std::vector<LobeSample>& samples, double floor, const double* parameters, int lobes,
                    double* residuals, double* jacobian) {
  const int columns = lobes * kLobeParameters;
  for (size_t i = 0; i < samples.size(); ++i) {
    double* row = jacobian == nullptr ? nullptr : jacobian + i * static_cast<size_t>(columns);
    for (int c = 0; row != nullptr && c < columns; ++c) row[c] = 0.0;
    double density = floor * floor;
    for (int lobe = 0; lobe < lobes; ++lobe) {
      const double* p = parameters + lobe * kLobeParameters;
      double* gradient = row == nullptr ? nullptr : row + lobe * kLobeParameters;
      density += half_lobe(samples[i], p, 1.0, gradient) + half_lobe(samples[i], p, -1.0, gradient);
    }
    const double magnitude = std::sqrt(density);
    residuals[i] = magnitude - samples[i].magnitude;
    for (int c = 0; row != nullptr && c < columns; ++c) row[c] *= 0.5 / magnitude;
  }
}

}  // namespace texbake
