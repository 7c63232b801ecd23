#include "libbake/height/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

constexpr int kRefinedSide = 32;

Image<float> noise(uint64_t seed) {
  Random random(seed);
  Image<float> image(kRefinedSide, kRefinedSide);
  for (float& value : image) value = random.uniform();
  return image;
}

Image<V3f> colors(uint64_t seed, float contrast) {
  Random random(seed);
  Image<V3f> image(kRefinedSide, kRefinedSide);
  for (V3f& color : image) color = V3f(random.uniform(), random.uniform(), random.uniform()) * contrast;
  return image;
}

double deviation(const Image<float>& image, int x0, int x1) {
  double sum = 0, square = 0;
  const double count = (x1 - x0) * image.height();
  for (int y = 0; y < image.height(); ++y)
    for (int x = x0; x < x1; ++x) sum += image(x, y), square += image(x, y) * image(x, y);
  return std::sqrt(square / count - sum * sum / count / count);
}

TEST(Refine, StrengthZeroChangesNothing) {
  const Image<float> heights = noise(1);
  const Image<float> refined = refine(heights, colors(2, 5), 0);
  EXPECT_TRUE(std::ranges::equal(heights, refined));
}

TEST(Refine, AFlatHeightStaysFlat) {
  for (const float h : refine(Image<float>(kRefinedSide, kRefinedSide, 0.7f), colors(3, 5), 16)) EXPECT_EQ(h, 0.7f);
}

TEST(Refine, TheMeanStays) {
  const Image<float> heights = noise(4);
  const Image<float> refined = refine(heights, colors(5, 5), 16);
  double before = 0, after = 0;
  for (size_t i = 0; i < heights.size(); ++i) before += heights.data()[i], after += refined.data()[i];
  EXPECT_NEAR(after / before, 1.0, 1e-4);
}

TEST(Refine, NoSmallChangeMakesTheSumLess) {
  // The sum of refine.h, written as it stands there.
  const Image<float> propagated = noise(6);
  const Image<V3f> luv = colors(7, 8);
  const float strength = 16;
  const Image<V3f> smooth = gaussian_blur(luv, 1.0, Wrap::repeat);
  const auto energy = [&](const Image<float>& h) {
    double sum = 0;
    for (int y = 0; y < kRefinedSide; ++y)
      for (int x = 0; x < kRefinedSide; ++x) {
        sum += std::pow(h(x, y) - propagated(x, y), 2.0);
        for (const V2i& q : {V2i(wrap(x + 1, kRefinedSide), y), V2i(x, wrap(y + 1, kRefinedSide))})
          sum +=
              strength * std::exp(-(smooth(x, y) - smooth(q.x, q.y)).length()) * std::pow(h(x, y) - h(q.x, q.y), 2.0);
      }
    return sum;
  };
  const Image<float> best = refine(propagated, luv, strength);
  EXPECT_LT(energy(best), energy(propagated));
  Random random(8);
  for (int trial = 0; trial < 20; ++trial) {
    Image<float> other = best.clone();
    for (float& h : other) h += 0.01f * (random.uniform() - 0.5f);
    EXPECT_GT(energy(other), energy(best));
  }
}

TEST(Refine, SmoothsAnEvenSurfaceAndKeepsTheEdgesOfItsColors) {
  // Two halves 40 ΔE apart, 0.2 and 0.8 high under noise of 0.2.
  Image<float> heights = noise(9);
  Image<V3f> luv(kRefinedSide, kRefinedSide);
  for (int y = 0; y < kRefinedSide; ++y)
    for (int x = 0; x < kRefinedSide; ++x) {
      heights(x, y) = (x < 16 ? 0.2f : 0.8f) + 0.2f * (heights(x, y) - 0.5f);
      luv(x, y) = V3f(x < 16 ? 30.0f : 70.0f, 0, 0);
    }
  const Image<float> refined = refine(heights, luv, 64);
  EXPECT_LT(deviation(refined, 0, 16), 0.3 * deviation(heights, 0, 16));
  double step = 0;
  for (int y = 0; y < kRefinedSide; ++y) step += refined(16, y) - refined(15, y);
  EXPECT_NEAR(step / kRefinedSide, 0.6, 0.03);  // the edge shields its texels: 0.058 of noise, over 32 rows
}

}  // namespace
}  // namespace texbake
