#include "libbake/content/low_passed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbake {
namespace {

TEST(LowPassed, HasAtMostAbout64CellsAlongTheShorterSide) {
  EXPECT_EQ(low_passed(Image<V3f>(512, 256)).grid.cells, V2i(128, 64));
  EXPECT_EQ(low_passed(Image<V3f>(300, 211)).grid.cells, V2i(91, 64));  // 64 · 300 / 211 = 90.99
  EXPECT_EQ(low_passed(Image<V3f>(40, 30)).grid.cells, V2i(40, 30));
}

TEST(LowPassed, KeepsALongWaveAndDropsAShortOneAndTheMean) {
  const auto wave = [](double length_px) {
    Image<V3f> image(256, 256);
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x)
        image(x, y) = V3f(50.0f + 10.0f * static_cast<float>(std::cos(2.0 * M_PI * x / length_px)), 0, 0);
    return image;
  };
  // A Gaussian of σ = 16 px leaves exp(−2π²σ²/λ²) of a wave's amplitude: 0.926 at 256 px, 0.0072 at 32 px. The mean
  // of its square is half the amplitude's. 3 %: cells of 4 px and a kernel cut at 3 σ.
  EXPECT_NEAR(low_passed(wave(256)).energy, 0.5 * std::pow(10 * 0.926, 2), 0.03 * 43);
  EXPECT_LT(low_passed(wave(32)).energy, 0.5 * std::pow(10 * 0.01, 2));
}

TEST(LowPassed, IsWiderWhereTheTileIsSeenSmaller) {
  // Seen at half the size a wave of 256 px is one of 128 px: exp(−2π²σ²/128²) = 0.735 of its amplitude.
  Image<V3f> image(256, 256);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) image(x, y) = V3f(10.0f * static_cast<float>(std::cos(2.0 * M_PI * x / 256.0)), 0, 0);
  EXPECT_NEAR(low_passed(image, 0.5f).energy, 0.5 * std::pow(10 * 0.735, 2), 0.03 * 27);
}

}  // namespace
}  // namespace texbake
