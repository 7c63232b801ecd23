#include "libbake/quality/repetition.h"

#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

Image<V3f> white_noise(int width, int height, uint32_t seed) {
  Random random(seed);
  Image<V3f> image(width, height);
  for (V3f& c : image) c = V3f(random.uniform(), random.uniform(), random.uniform()) * 100.0f;
  return image;
}

Image<V3f> repeat(const Image<V3f>& tile, int times) {
  Image<V3f> image(tile.width() * times, tile.height() * times);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) image(x, y) = tile(x % tile.width(), y % tile.height());
  return image;
}

TEST(Repetition, APeriodicTextureRepeatsWholly) {
  const Image<V3f> image = repeat(white_noise(32, 16, 1), 4);
  for (const double sigma : {0.0, 0.5, 2.0}) EXPECT_NEAR(repetition(image, {32, 16}, sigma)->share, 1.0, 1e-5);
}

TEST(Repetition, IndependentTilesDoNotRepeat) {
  // The share's standard deviation is about sqrt(2 / texels) = 0.01.
  EXPECT_NEAR(repetition(white_noise(128, 128, 2), {32, 32}, 0.0)->share, 0.0, 0.04);
}

TEST(Repetition, HalfTheVarianceFromARepeatedPartIsOneHalf) {
  Image<V3f> image = repeat(white_noise(32, 32, 3), 6);
  const Image<V3f> fresh = white_noise(192, 192, 4);
  for (size_t i = 0; i < image.size(); ++i) image.data()[i] += fresh.data()[i];
  EXPECT_NEAR(repetition(image, {32, 32}, 0.0)->share, 0.5, 0.03);
}

TEST(Repetition, IsNotDefinedForAConstant) {
  EXPECT_FALSE(repetition(Image<V3f>(64, 64, V3f(50, 0, 0)), {32, 32}, 0.0).has_value());
}

TEST(Repetition, TheAmplitudeIsThatOfTheRepeatedPart) {
  // The repeated part is uniform in a cube of 100: deviation 100 · sqrt(3/12) = 50 in all; fresh noise adds none.
  Image<V3f> image = repeat(white_noise(64, 64, 3), 6);
  const Image<V3f> fresh = white_noise(384, 384, 4);
  for (size_t i = 0; i < image.size(); ++i) image.data()[i] += fresh.data()[i];
  EXPECT_NEAR(repetition(image, {64, 64}, 0.0)->amplitude_delta_e, 50.0, 1.0);
}

TEST(RepetitionMap, IsWhiteWhereTheTileRepeatsAndBlackWhereItDoesNot) {
  // The left half of every tile is the same, the right half is new each time.
  Image<V3f> image = white_noise(384, 384, 5);
  const Image<V3f> tile = white_noise(64, 64, 6);
  for (int y = 0; y < 384; ++y)
    for (int x = 0; x < 384; ++x)
      if (x % 64 < 32) image(x, y) = tile(x % 64, y % 64);
  const Image<float> map = repetition_map(image, {64, 64});
  ASSERT_EQ(map.width(), 64);
  for (int y = 0; y < 64; ++y) {
    EXPECT_GT(map(16, y), 0.9f);
    EXPECT_LT(map(48, y), 0.2f);
  }
}

TEST(RepetitionMap, OfAConstantIsBlack) {
  for (const float share : repetition_map(Image<V3f>(64, 64, V3f(50, 0, 0)), {32, 32})) EXPECT_EQ(share, 0.0f);
}

TEST(Repetition, RefusesPartsOfTiles) { EXPECT_THROW(repetition(Image<V3f>(65, 64), {32, 32}, 0.0), Error); }

}  // namespace
}  // namespace texbake
