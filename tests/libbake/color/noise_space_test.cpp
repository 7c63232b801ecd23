#include "libbake/color/noise_space.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(NoiseSpace, RootAndLightAreInverse) {
  Image<V3f> light(3, 1);
  light(0, 0) = {0, 0.25f, 4};
  light(1, 0) = {-0.5f, 1, 0.01f};
  const Image<V3f> root = in_noise_space(light, NoiseSpace::root);
  EXPECT_EQ(root(0, 0), V3f(0, 0.5f, 2));
  EXPECT_EQ(root(1, 0), V3f(0, 1, std::sqrt(0.01f))) << "below black there is none";
  EXPECT_EQ(to_light(root, NoiseSpace::root)(0, 0), light(0, 0));
  EXPECT_EQ(in_noise_space(light, NoiseSpace::linear), light);
  EXPECT_EQ(to_light(light, NoiseSpace::linear), light);
}

}  // namespace
}  // namespace texbake
