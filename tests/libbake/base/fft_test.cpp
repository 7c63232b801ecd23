#include "libbake/base/fft.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbake {
namespace {

TEST(Fft, ACosineHasTwoLines) {
  constexpr int kSize = 12;
  Image<double> wave(kSize, kSize);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) wave(x, y) = std::cos(2.0 * M_PI * (3 * x + 2 * y) / kSize);
  const auto spectrum = fft<double>(wave);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const bool line = (x == 3 && y == 2) || (x == kSize - 3 && y == kSize - 2);
      EXPECT_NEAR(std::abs(spectrum(x, y)), line ? kSize * kSize / 2.0 : 0.0, 1e-10);
    }
}

TEST(Fft, TheInverseGivesTheImageBack) {
  Image<float> image(10, 7);
  for (size_t i = 0; i < image.size(); ++i) image.data()[i] = static_cast<float>((i * 37) % 11);
  const Image<float> back = inverse_fft_real<float>(fft<float>(image));
  for (size_t i = 0; i < image.size(); ++i) EXPECT_NEAR(back.data()[i], image.data()[i], 1e-5f);  // 10 float steps
}

}  // namespace
}  // namespace texbake
