#include "libbake/noise/lobe_cost.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/noise/lobes.h"

namespace texbake {
namespace {

const std::vector<double> kTwoLobes = {0.6, 0.12, -0.07, 20.0, 3.0, 9.0, 0.3, 0.0, 0.0, 6.0, -1.0, 8.0};

std::vector<LobeSample> some_samples() {
  std::vector<LobeSample> samples;
  for (int i = 0; i < 40; ++i) samples.push_back({0.5 * (i % 8) / 8.0, 0.5 * (i / 8) / 5.0 - 0.2, 0.5});
  return samples;
}

TEST(LobeCost, DerivativesEqualDifferenceQuotients) {
  const auto samples = some_samples();
  std::vector<double> residuals(samples.size());
  std::vector<double> jacobian(samples.size() * kTwoLobes.size());
  lobe_residuals(samples, 0.02, kTwoLobes.data(), 2, residuals.data(), jacobian.data());
  for (size_t p = 0; p < kTwoLobes.size(); ++p) {
    constexpr double kStep = 1e-6;
    auto up = kTwoLobes;
    auto down = kTwoLobes;
    up[p] += kStep;
    down[p] -= kStep;
    std::vector<double> a(samples.size());
    std::vector<double> b(samples.size());
    lobe_residuals(samples, 0.02, up.data(), 2, a.data(), nullptr);
    lobe_residuals(samples, 0.02, down.data(), 2, b.data(), nullptr);
    for (size_t i = 0; i < samples.size(); ++i)
      EXPECT_NEAR(jacobian[i * kTwoLobes.size() + p], (a[i] - b[i]) / (2.0 * kStep), 1e-5) << p << " " << i;
  }
}

TEST(LobeCost, IsTheDensityOfTheLobes) {
  const auto samples = some_samples();
  std::vector<double> residuals(samples.size());
  lobe_residuals(samples, 0.02, kTwoLobes.data(), 2, residuals.data(), nullptr);
  const Lobe lobes[] = {{0.6, 0.12, -0.07, 20.0, 3.0, 9.0}, {0.3, 0.0, 0.0, 6.0, -1.0, 8.0}};
  for (size_t i = 0; i < samples.size(); ++i) {
    const double density =
        lobes[0].density(samples[i].fx_cpp, samples[i].fy_cpp) + lobes[1].density(samples[i].fx_cpp, samples[i].fy_cpp);
    EXPECT_NEAR(residuals[i], std::sqrt(density + 0.0004) - 0.5, 1e-12);
  }
}

}  // namespace
}  // namespace texbake
