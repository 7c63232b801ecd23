#include "libbake/quality/low_pass.h"

#include <gtest/gtest.h>

#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

TEST(LowPass, EqualsTheFullGaussianAtTheMiddleOfEachBlock) {
  Random random(2);
  Image<V3f> image(128, 128);
  for (V3f& c : image) c = V3f(random.uniform(), 0.0f, 0.0f);
  const Image<V3f> full = gaussian_blur(image, 16.0, Wrap::repeat);
  const Image<V3f> reduced = low_pass(image, 16.0, 4);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const float middle = (full(4 * x + 1, 4 * y + 1).x + full(4 * x + 2, 4 * y + 1).x + full(4 * x + 1, 4 * y + 2).x +
                            full(4 * x + 2, 4 * y + 2).x) /
                           4.0f;
      EXPECT_NEAR(reduced(x, y).x, middle, 1e-3f);  // both Gaussians are cut at 3 sigma; the picture deviates by 5e-3
    }
}

TEST(LowPass, ReducesWhileTheGaussianStaysTwoTexelsWide) {
  EXPECT_EQ(reduction_factor({1024, 1024}, 64.0), 32);
  EXPECT_EQ(reduction_factor({1024, 1024}, 3.9), 1);
  EXPECT_EQ(reduction_factor({1024, 1028}, 64.0), 4);
}

}  // namespace
}  // namespace texbake
