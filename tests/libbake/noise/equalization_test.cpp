#include "libbake/noise/equalization.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/random.h"

namespace texbake {
namespace {

TEST(NormalCumulative, IsTheErrorFunction) {
  for (int i = 0; i < Equalization::kEntries; ++i) {
    const double g = (2.0 * i / (Equalization::kEntries - 1) - 1.0) * Equalization::kRange;
    EXPECT_NEAR(normal_cumulative()[size_t(i)], 0.5 * std::erfc(-g / std::sqrt(2.0)),
                1e-8);  // Simpson's rule at 256 steps
  }
}

TEST(Equalization, OfUniformValuesIsTheirQuantile) {
  Random random(3);
  Image<float> channel(256, 256);
  for (float& value : channel) value = 2.0f + random.uniform();
  const Equalization transfer = match_histogram(channel, Image<uint8_t>(256, 256, 1), 2.5);
  for (const double g : {-3.0, -1.0, -0.25, 0.0, 0.5, 2.0})
    EXPECT_NEAR(transfer(g), 0.5 * std::erfc(-g / std::sqrt(2.0)) - 0.5, 0.006);  // 3 standard errors of 65536 ranks
  EXPECT_EQ(transfer(9.0), transfer(4.0));
}

TEST(Equalization, RisesAndSeesOnlyTheMask) {
  Image<float> channel(32, 32);
  Image<uint8_t> mask(32, 32);
  for (int i = 0; i < 32; ++i) {
    mask(i, 7) = 1;
    channel(i, 7) = static_cast<float>(i % 5) - 2.0f;
    channel(i, 9) = 1e6f;
  }
  const Equalization transfer = match_histogram(channel, mask, 0.0);
  for (size_t i = 1; i < transfer.values.size(); ++i) EXPECT_GE(transfer.values[i], transfer.values[i - 1]);
  EXPECT_LE(transfer.values.back(), 2.001f);
}

TEST(Equalization, OfAConstantIsZero) {
  const Equalization transfer = match_histogram(Image<float>(8, 8, 3.0f), Image<uint8_t>(8, 8, 1), 3.0);
  EXPECT_EQ(transfer(1.5), 0.0f);
}

}  // namespace
}  // namespace texbake
