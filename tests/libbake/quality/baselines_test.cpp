#include "libbake/quality/baselines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"
#include "libbake/color/luv.h"
#include "libbake/quality/fidelity.h"
#include "libbake/quality/repetition.h"

namespace texbake {
namespace {

Image<V3f> grain(int width, int height) {
  Random random(3);
  Image<V3f> image(width, height);
  for (V3f& c : image) c = V3f(random.uniform(), random.uniform(), random.uniform());
  return gaussian_blur(image, 1.0, Wrap::repeat);
}

TEST(Baselines, PeriodicRepeatsWholly) {
  EXPECT_NEAR(repetition(periodic_baseline(grain(32, 32), 128, 128), {32, 32}, 1.0)->share, 1.0, 1e-5);
}

TEST(Baselines, WangTilesRepeatInPart) {
  const double share = repetition(wang_baseline(grain(64, 64), {6, 6}, 1), {64, 64}, 0.0)->share;
  EXPECT_GT(share, 0.3);  // four side pictures of which a tile shows two by chance: about one half
  EXPECT_LT(share, 0.7);
}

TEST(Baselines, WangTilesShowNoEdgeBetweenThem) {
  const Image<V3f> exemplar = grain(64, 48);
  const Image<V3f> picture = wang_baseline(exemplar, {4, 4}, 2);
  double border = 0.0;
  double inside = 0.0;
  for (int y = 0; y < picture.height(); ++y) {
    border += (picture(63, y) - picture(64, y)).length();
    inside += (picture(9, y) - picture(10, y)).length();
  }
  EXPECT_NEAR(border / inside, 1.0, 0.25);
}

TEST(Baselines, WangTilingShowsItsSources) {
  const Image<V3f> exemplar = grain(64, 48);
  const Image<V3f> picture = wang_baseline(exemplar, {3, 2}, 5);
  const WangTiling tiling(luv_from_linear(exemplar), {3, 2}, 5);
  ASSERT_EQ(tiling.size_px(), V2i(picture.width(), picture.height()));
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const V2i source = tiling.source(x, y);
      ASSERT_EQ(picture(x, y), exemplar(source.x, source.y));
    }
}

TEST(Baselines, HexTilingDoesNotRepeat) {
  EXPECT_NEAR(repetition(hex_baseline_rows(grain(64, 64), 384, 0, 384, 1), {64, 64}, 0.0)->share, 0.0, 0.03);
}

TEST(Baselines, HexTilingIsTheSameByStrips) {
  const Image<V3f> exemplar = grain(64, 64);
  const Image<V3f> whole = hex_baseline_rows(exemplar, 100, 0, 50, 1);
  const Image<V3f> strip = hex_baseline_rows(exemplar, 100, 20, 50, 1);
  EXPECT_TRUE(std::equal(strip.begin(), strip.end(), whole.row(20)));
}

TEST(Baselines, HexTilingOfAConstantIsTheConstant) {
  for (const V3f& c : hex_baseline_rows(Image<V3f>(16, 16, V3f(0.25f, 0.5f, 0.75f)), 40, 0, 30, 1)) {
    EXPECT_NEAR(c.x, 0.25f, 1e-6f);  // weights sum to one within float rounding
    EXPECT_NEAR(c.z, 0.75f, 1e-6f);
  }
}

}  // namespace
}  // namespace texbake
