// Levenberg and Marquardt by Ceres, dense and in one thread, on half of the frequencies (the other half mirrors it).
#include "libbake/noise/lobes.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libbake/base/portable_math.h"
#include "libbake/base/torus.h"
#include "libbake/noise/lobe_cost.h"
#include "libbake/noise/spectrum.h"

namespace texbake {
namespace {

constexpr double kFloor = 0.02;  // of the magnitude of white noise: keeps the square root smooth

/// All residuals in one block, so that the derivatives are ours.
class LobeCost : public ceres::CostFunction {
 public:
  LobeCost(const std::vector<LobeSample>& samples, int lobes) : samples_(samples), lobes_(lobes) {
    mutable_parameter_block_sizes()->push_back(lobes * kLobeParameters);
    set_num_residuals(static_cast<int>(samples.size()));
  }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    lobe_residuals(samples_, kFloor, parameters[0], lobes_, residuals, jacobians == nullptr ? nullptr : jacobians[0]);
    return true;
  }

 private:
  const std::vector<LobeSample>& samples_;
  int lobes_;
};

/// The frequencies of the upper half plane but 0, magnitudes scaled to white noise = 1.
std::vector<LobeSample> samples_of(ImageView<const float> spectrum, double power) {
  const int size = spectrum.width();
  const double scale = size / std::sqrt(power);
  std::vector<LobeSample> samples;
  for (int y = 0; y <= size / 2; ++y)
    for (int x = 0; x < size; ++x) {
      const int fx = shortest(x, size);
      const int fy = shortest(y, size);
      if ((y == 0 || 2 * y == size) && fx < 0 && 2 * fx != -size) continue;  // its mirror is there
      if (fx == 0 && fy == 0) continue;
      samples.push_back({fx / static_cast<double>(size), fy / static_cast<double>(size),
                         scale * static_cast<double>(spectrum(x, y))});
    }
  return samples;
}

using Start = std::vector<double>;

void add_lobe(Start& start, double power, double x, double y, double width_cpp) {
  if (x < 0.0) {
    x = -x;
    y = -y;
  }
  start.insert(start.end(), {power, x, y, 1.0 / width_cpp, 0.0, 1.0 / width_cpp});
}

/// Lobes around frequency 0, each 2.2 times as wide as the one before.
Start nested_start(int lobes, double narrowest_cpp) {
  Start start;
  double width = narrowest_cpp;
  for (int i = 0; i < lobes; ++i, width *= 2.2) add_lobe(start, 1.0 / lobes, 0.0, 0.0, width);
  return start;
}

/// Lobes at the highest peaks of the table, each at least 0.12 cycles per texel (on the torus of ±f) from the others.
Start peak_start(const std::vector<LobeSample>& samples, int lobes) {
  Start start;
  std::vector<size_t> peaks;
  constexpr double kApart = 0.12;
  while (static_cast<int>(peaks.size()) < lobes) {
    size_t best = samples.size();
    for (size_t i = 0; i < samples.size(); ++i) {
      const bool near = std::any_of(peaks.begin(), peaks.end(), [&](size_t p) {
        const auto apart = [&](double sign) {
          const double dx = samples[i].fx_cpp - sign * samples[p].fx_cpp;
          const double dy = samples[i].fy_cpp - sign * samples[p].fy_cpp;
          return dx * dx + dy * dy;
        };
        return std::min(apart(1.0), apart(-1.0)) < kApart * kApart;
      });
      if (!near && (best == samples.size() || samples[i].magnitude > samples[best].magnitude)) best = i;
    }
    if (best == samples.size()) break;
    peaks.push_back(best);
  }
  for (const size_t p : peaks)
    add_lobe(start, 1.0 / static_cast<double>(peaks.size()), samples[p].fx_cpp, samples[p].fy_cpp, 0.06);
  return start;
}

/// Solves from `start`; the sum of squared residuals after it.
double solve(const std::vector<LobeSample>& samples, int table_size, Start& start) {
  const int lobes = static_cast<int>(start.size()) / kLobeParameters;
  ceres::Problem problem;
  problem.AddResidualBlock(new LobeCost(samples, lobes), nullptr, start.data());
  const double narrowest = 2.0 * table_size;  // half a bin
  for (int lobe = 0; lobe < lobes; ++lobe) {
    const auto bound = [&](int parameter, double least, double most) {
      problem.SetParameterLowerBound(start.data(), lobe * kLobeParameters + parameter, least);
      problem.SetParameterUpperBound(start.data(), lobe * kLobeParameters + parameter, most);
    };
    bound(0, 0.0, 16.0);
    bound(1, 0.0, 0.5);
    bound(2, -0.5, 0.5);
    bound(3, 1.0, narrowest);
    bound(4, -narrowest, narrowest);
    bound(5, 1.0, narrowest);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.dense_linear_algebra_library_type = ceres::EIGEN;
  options.num_threads = 1;
  options.max_num_iterations = 40;
  options.max_solver_time_in_seconds = 1e9;  // never a matter of the machine's speed
  options.function_tolerance = 1e-4;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return 2.0 * summary.final_cost;
}

double round_to_20_bits(double value) {
  if (value == 0.0) return 0.0;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, 20)), exponent - 20);
}

std::vector<Lobe> lobes_of(const Start& solution, double power) {
  std::vector<Lobe> lobes;
  for (size_t i = 0; i < solution.size(); i += kLobeParameters) {
    const double* p = solution.data() + i;
    if (p[0] <= 1e-4) continue;
    lobes.push_back({round_to_20_bits(p[0] * power), round_to_20_bits(p[1]), round_to_20_bits(p[2]),
                     round_to_20_bits(p[3]), round_to_20_bits(p[4]), round_to_20_bits(p[5])});
  }
  std::stable_sort(lobes.begin(), lobes.end(), [](const Lobe& a, const Lobe& b) { return a.power > b.power; });
  return lobes;
}

double magnitude_error(ImageView<const float> a, ImageView<const float> b) {
  double difference = 0.0;
  double total = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double d = static_cast<double>(a.data()[i]) - static_cast<double>(b.data()[i]);
    difference += d * d;
    total += static_cast<double>(b.data()[i]) * static_cast<double>(b.data()[i]);
  }
  return total > 0.0 ? std::sqrt(difference / total) : 0.0;
}

}  // namespace

double Lobe::density(double fx_cpp, double fy_cpp) const {
  double sum = 0.0;
  for (const double sign : {1.0, -1.0}) {
    const double dx = fx_cpp - sign * center_x_cpp;
    const double dy = fy_cpp - sign * center_y_cpp;
    const double a = l_xx * dx + l_xy * dy;
    const double b = l_yy * dy;
    sum += portable_exp(-0.5 * (a * a + b * b));
  }
  return power / 2.0 * l_xx * l_yy / (2.0 * std::numbers::pi) * sum;
}

LobeFit fit_lobes(ImageView<const float> spectrum, int most) {
  const double power = spectrum_power(spectrum);
  if (!(power > 0.0)) return {};
  const std::vector<LobeSample> samples = samples_of(spectrum, power);
  LobeFit best;
  double best_cost = 0.0;
  for (Start start : {nested_start(most, 0.03), nested_start(most, 0.08), peak_start(samples, most)}) {
    const double cost = solve(samples, spectrum.width(), start);
    if (!best.lobes.empty() && cost >= best_cost) continue;
    best_cost = cost;
    best.lobes = lobes_of(start, power);
  }
  best.error = magnitude_error(lobe_spectrum(best.lobes, spectrum.width()), spectrum);
  return best;
}

Image<float> lobe_spectrum(std::span<const Lobe> lobes, int size) {
  Image<double> density(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (const Lobe& lobe : lobes)
        density(x, y) +=
            lobe.density(shortest(x, size) / static_cast<double>(size), shortest(y, size) / static_cast<double>(size));
  Image<float> spectrum(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (x == 0 && y == 0) continue;
      // ½ and −½ cycle per texel are one row of the table: their mean.
      const double both = 0.5 * (density(x, y) + density(wrap(-x, size), wrap(-y, size)));
      spectrum(x, y) = static_cast<float>(std::sqrt(both) / size);
    }
  return spectrum;
}

double filtered_variance(std::span<const Lobe> lobes, double xx, double xy, double yy) {
  // ∫ N(f; c, P⁻¹) exp(−½ fᵀ B f) df = sqrt(|P| / |P + B|) · exp(−½ cᵀ (P − P (P + B)⁻¹ P) c), B = 8π² C.
  const double factor = 8.0 * std::numbers::pi * std::numbers::pi;
  double variance = 0.0;
  for (const Lobe& lobe : lobes) {
    const double pxx = lobe.l_xx * lobe.l_xx;
    const double pxy = lobe.l_xx * lobe.l_xy;
    const double pyy = lobe.l_xy * lobe.l_xy + lobe.l_yy * lobe.l_yy;
    const double sxx = pxx + factor * xx;
    const double sxy = pxy + factor * xy;
    const double syy = pyy + factor * yy;
    const double determinant = sxx * syy - sxy * sxy;
    const double cx = lobe.center_x_cpp;
    const double cy = lobe.center_y_cpp;
    const double qx = pxx * cx + pxy * cy;
    const double qy = pxy * cx + pyy * cy;
    const double inner = (qx * (syy * qx - sxy * qy) + qy * (sxx * qy - sxy * qx)) / determinant;
    const double outer = cx * qx + cy * qy;
    variance += lobe.power * std::sqrt((pxx * pyy - pxy * pxy) / determinant) * portable_exp(-0.5 * (outer - inner));
  }
  return variance;
}

}  // namespace texbake
