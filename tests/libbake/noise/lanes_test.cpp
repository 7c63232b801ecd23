#include "libbake/noise/lanes.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(Lanes, ExpOfNegativeIsExact) {
  for (float x = 0.0f; x <= 80.0f; x += 0.0371f)
    EXPECT_NEAR(exp_of_negative(splat(x))[2] / std::exp(-double(x)), 1.0, 5e-6)
        << x;  // x itself has 24 bits: 80 · 2^-24
}

TEST(Lanes, LogIsExact) {
  for (double x = 1e-6; x < 1e4; x *= 1.0113)
    EXPECT_NEAR(log_lanes(splat(static_cast<float>(x)))[1], std::log(double(static_cast<float>(x))), 1.5e-6) << x;
}

TEST(Lanes, LoadsAndStoresAnyPlace) {
  const float in[] = {0, 1, 2, 3, 4, 5};
  float out[6] = {};
  store_lanes(out + 1, load_lanes(in + 1));
  EXPECT_EQ(out[0], 0.0f);
  EXPECT_EQ(out[4], 4.0f);
  EXPECT_EQ(out[5], 0.0f);
  EXPECT_EQ(sum_lanes(load_lanes(in + 1)), 10.0f);
  EXPECT_EQ(round_to_lanes(5), 8);
}

}  // namespace
}  // namespace texbake
