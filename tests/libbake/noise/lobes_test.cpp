#include "libbake/noise/lobes.h"

#include <gtest/gtest.h>

#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

TEST(FitLobes, FindsTheLobesThatMadeATable) {
  const Lobe truth[] = {{0.7, 0.2, 0.1, 16.0, 2.0, 22.0}, {0.3, 0.0, 0.0, 12.0, 0.0, 12.0}};
  const LobeFit fit = fit_lobes(lobe_spectrum(truth, 32), 2);
  EXPECT_LT(fit.error, 0.03);
  ASSERT_EQ(fit.lobes.size(), 2u);
  EXPECT_NEAR(fit.lobes[0].power, 0.7, 0.05);
  EXPECT_NEAR(fit.lobes[0].center_x_cpp, 0.2, 0.01);
  EXPECT_NEAR(fit.lobes[0].center_y_cpp, 0.1, 0.01);
}

TEST(FitLobes, ABlobIsOneLobeAndZeroIsNone) {
  EXPECT_LT(fit_lobes(true_spectrum(blob_power, 32, 0.01), 2).error, 0.05);
  const LobeFit none = fit_lobes(Image<float>(32, 32), 3);
  EXPECT_TRUE(none.lobes.empty());
  EXPECT_EQ(none.error, 0.0);
}

TEST(FitLobes, SaysWhenItFails) {
  // A ring is no sum of two Gaussians.
  EXPECT_GT(fit_lobes(true_spectrum(ring_power, 32, 0.01), 2).error, 0.15);
}

TEST(FilteredVariance, IsTheIntegralOverTheFrequencies) {
  const Lobe lobes[] = {{0.7, 0.1, -0.05, 30.0, 8.0, 40.0}};
  for (const auto& [xx, xy, yy] : {std::tuple(0.0, 0.0, 0.0), std::tuple(1.0, 0.0, 1.0), std::tuple(4.0, 1.5, 2.0)}) {
    double integral = 0.0;
    constexpr int kSteps = 400;
    for (int j = 0; j < kSteps; ++j)
      for (int i = 0; i < kSteps; ++i) {
        const double fx = (i + 0.5) / kSteps - 0.5;
        const double fy = (j + 0.5) / kSteps - 0.5;
        integral += lobes[0].density(fx, fy) *
                    std::exp(-4.0 * M_PI * M_PI * (xx * fx * fx + 2.0 * xy * fx * fy + yy * fy * fy)) /
                    (kSteps * double(kSteps));
      }
    EXPECT_NEAR(filtered_variance(lobes, xx, xy, yy), integral, 1e-6);
  }
}

}  // namespace
}  // namespace texbake
