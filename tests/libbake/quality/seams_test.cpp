#include "libbake/quality/seams.h"

#include <gtest/gtest.h>

#include "libbake/base/random.h"

namespace texbake {
namespace {

Image<V3f> white_noise(int n, uint32_t seed) {
  Random random(seed);
  Image<V3f> image(n, n);
  for (V3f& c : image) c = V3f(random.uniform(), random.uniform(), random.uniform()) * 100.0f;
  return image;
}

// A rendering that shows the tile shifted by `shift` in its right half.
Image<V2i> half_shifted(int n, V2i shift) {
  Image<V2i> source(n, n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) source(x, y) = x < n / 2 ? V2i(x, y) : wrap(V2i(x, y) + shift, V2i(n, n));
  return source;
}

TEST(Seams, TheTileItselfHasNone) { EXPECT_FALSE(seams(white_noise(32, 1), half_shifted(32, {0, 0})).has_value()); }

TEST(Seams, AreInvisibleInWhiteNoise) {
  const auto found = seams(white_noise(256, 1), half_shifted(256, {77, 31}));
  EXPECT_EQ(found->pair_count, 256u);
  EXPECT_NEAR(found->auc_all, 0.5, 0.06);  // three standard deviations of 256 pairs: 3 · 0.29 / 16
  EXPECT_NEAR(found->auc_own, 0.5, 0.08);
  EXPECT_NEAR(found->tail_all, 0.05, 0.045);
}

TEST(Seams, AreSeenInASmoothRamp) {
  // Across the seam the ramp jumps by about a quarter of its range; everywhere else it steps by one texel's worth.
  Image<V3f> ramp(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ramp(x, y) = V3f(static_cast<float>(y < 32 ? y : 63 - y), 0, 0);
  const auto found = seams(ramp, half_shifted(64, {0, 16}));
  EXPECT_GT(found->auc_own, 0.85);
  EXPECT_GT(found->tail_own, 0.7);
  EXPECT_GT(found->run_px, 10.0);
}

TEST(Seams, PeriodicTilingIsAsVisibleAsItsWrapWasBefore) {
  // Every seam pair is the wrap itself, so that "own" compares a sample with itself.
  const Image<V3f> image = white_noise(32, 3);
  Image<V2i> source(96, 96);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) source(x, y) = V2i(x % 32, y % 32);
  EXPECT_FALSE(seams(image, source).has_value());
  const auto found = seams(image, source, {{}, Adjacency::plane});
  EXPECT_EQ(found->pair_count, 2u * 2u * 96u);
  EXPECT_DOUBLE_EQ(found->auc_own, 0.5);
  EXPECT_NEAR(found->tail_own, 0.05, 0.032);  // one of the 32 places of a wrap more or less
}

TEST(Seams, TexelsOfOneShapeMakeNone) {
  const Image<V3f> image = white_noise(32, 1);
  const Image<V2i> source = half_shifted(32, {5, 9});
  const Image<uint32_t> one(32, 32, 7);
  EXPECT_FALSE(seams(image, source, {one, Adjacency::torus}).has_value());
  Image<uint32_t> halves(32, 32, 7);
  for (int y = 0; y < 32; ++y)
    for (int x = 16; x < 32; ++x) halves(x, y) = 8;
  EXPECT_EQ(seams(image, source, {halves, Adjacency::torus})->pair_count, 32u);
}

TEST(Seams, AreMarkedAlongTheBorderAlone) {
  Image<V3f> ramp(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ramp(x, y) = V3f(static_cast<float>(y < 32 ? y : 63 - y), 0, 0);
  const Image<SeamTexel> texels = seam_texels(ramp, half_shifted(64, {0, 16}));
  int visible = 0;
  for (int y = 0; y < 64; ++y) {
    EXPECT_EQ(texels(30, y), SeamTexel::none);
    EXPECT_NE(texels(31, y), SeamTexel::none);
    EXPECT_NE(texels(32, y), SeamTexel::none);
    visible += texels(31, y) == SeamTexel::visible;
  }
  EXPECT_GT(visible, 50);  // the ramp jumps by 16 almost everywhere, and stepped by nothing across this border before
}

}  // namespace
}  // namespace texbake
