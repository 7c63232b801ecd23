#include "libbake/base/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbake {
namespace {

TEST(PortableMath, AgreesWithTheCLibraryWithinAFewUnits) {
  for (double x = -20.0; x <= 20.0; x += 0.0137) {
    EXPECT_NEAR(portable_exp(x) / std::exp(x), 1.0, 1e-15);
    EXPECT_NEAR(portable_cos(x), std::cos(x), 1e-15);
    EXPECT_NEAR(portable_sin(x), std::sin(x), 1e-15);
    EXPECT_NEAR(portable_cbrt(x), std::cbrt(x), 1e-15 * std::fabs(std::cbrt(x)));
  }
  for (double x = 1e-6; x < 1e6; x *= 1.013) {
    EXPECT_NEAR(portable_log(x), std::log(x), 1e-15 * (1.0 + std::fabs(std::log(x))));
    EXPECT_NEAR(portable_pow(x, 2.4) / std::pow(x, 2.4), 1.0, 1e-13);
  }
}

TEST(PortableMath, KeepsTheLimits) {
  EXPECT_EQ(portable_exp(-1000.0), 0.0);
  EXPECT_TRUE(std::isinf(portable_exp(1000.0)));
  EXPECT_TRUE(std::isinf(portable_log(0.0)));
  EXPECT_EQ(portable_pow(0.0, 2.4), 0.0);
  EXPECT_EQ(portable_cbrt(0.0), 0.0);
  EXPECT_EQ(portable_cbrt(27.0), 3.0);
}

}  // namespace
}  // namespace texbake
