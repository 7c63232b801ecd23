#include "libbake/base/mean.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(Mean, IsThatOfEachCoordinateAndKeepsSmallOnesBesideLargeOnes) {
  // 2^24 ones after another would stay at 2^24 if they were summed in float.
  Image<V3f> image(4096, 4097, V3f(1, 0, 0.25f));
  image(0, 0) = V3f(1, 4096 * 4097, 0.25f);
  EXPECT_EQ(mean_of(image), V3f(1, 1, 0.25f));
}

}  // namespace
}  // namespace texbake
