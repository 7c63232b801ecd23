#include "libbake/noise/spectrum_difference.h"

#include <gtest/gtest.h>

#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

TEST(SpectrumDifference, IsTenTimesTheLogarithmOfThePowerRatio) {
  const Image<float> a = true_spectrum(blob_power, 32, 1.0);
  const Image<float> b = true_spectrum(blob_power, 32, 10.0);
  EXPECT_NEAR(spectrum_difference_db(a, a), 0.0, 1e-12);
  EXPECT_NEAR(spectrum_difference_db(a, b), 10.0, 1e-4);
}

TEST(SpectrumDifference, SeesTheDirection) {
  const Image<float> along_x =
      true_spectrum([](double fx, double fy) { return std::exp(-50 * fx * fx - 500 * fy * fy); }, 32, 1.0);
  const Image<float> along_y =
      true_spectrum([](double fx, double fy) { return std::exp(-500 * fx * fx - 50 * fy * fy); }, 32, 1.0);
  EXPECT_GT(spectrum_difference_db(along_x, along_y), 6.0);
}

TEST(SpectrumDifference, OfNothingIsNothing) {
  const Image<float> zero(16, 16);
  EXPECT_EQ(spectrum_difference_db(zero, zero), 0.0);
  EXPECT_TRUE(std::isinf(spectrum_difference_db(zero, true_spectrum(blob_power, 16, 1.0))));
}

}  // namespace
}  // namespace texbake
