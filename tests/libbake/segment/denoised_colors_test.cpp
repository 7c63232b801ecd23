#include "libbake/segment/denoised_colors.h"

#include <gtest/gtest.h>

#include "libbake/base/half.h"
#include "tests/libbake/segment/random_tile.h"

namespace texbake {
namespace {

TEST(DenoisedColors, WithoutDenoisingItIsTheColorsAsTheyAre) {
  const auto tile = random_tile(20, 12, 3, 1);
  const auto denoised = denoised_colors(tile, 0);
  EXPECT_EQ(denoised.index, tile.index);
  EXPECT_EQ(denoised.variation, tile.variation);
  EXPECT_EQ(denoised.luv, luv_of(tile));
}

TEST(DenoisedColors, AFlatPictureStaysInItsClass) {
  auto tile = random_tile(20, 12, 3, 1);
  for (size_t at = 0; at < tile.index.size(); ++at) {
    tile.index.data()[at] = 1;
    tile.variation.data()[at] = 2.5f;
  }
  const auto denoised = denoised_colors(tile, 2);
  EXPECT_EQ(denoised.index, tile.index);
  for (const float v : denoised.variation) EXPECT_NEAR(v, 2.5f, 1e-4);  // a dozen roundings of floats near 60
}

TEST(DenoisedColors, ASingleTexelOfAnotherClassIsGrain) {
  auto tile = random_tile(20, 12, 2, 1);
  for (size_t at = 0; at < tile.index.size(); ++at) {
    tile.index.data()[at] = 0;
    tile.variation.data()[at] = 0;
  }
  tile.index(0, 0) = 1;
  for (const uint8_t k : denoised_colors(tile, 1.5f).index) EXPECT_EQ(k, 0);
}

TEST(DenoisedColors, AStraightBorderBetweenTwoClassesStaysWhereItIs) {
  auto tile = random_tile(24, 12, 2, 1);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 24; ++x) {
      tile.index(x, y) = x < 12 ? 0 : 1;
      tile.variation(x, y) = 0;
    }
  EXPECT_EQ(denoised_colors(tile, 1.5f).index, tile.index);
}

TEST(DenoisedColors, MedianVariationIsTheMiddleMagnitude) {
  Image<float> v(5, 1);
  const float values[5] = {-7, 1, 0, 3, -2};
  std::copy(values, values + 5, v.begin());
  EXPECT_EQ(median_variation(v), 2.0f);
}

}  // namespace
}  // namespace texbake
