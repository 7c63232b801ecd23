#include "libbake/content/translation_lattice.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "libbake/base/random.h"

namespace texbake {
namespace {

// Light bricks of 32 × 16 texels in dark mortar, every second row half a brick further; each brick of its own shade.
Image<V3f> bricks(int side) {
  Random random(3);
  Image<float> shade(side / 16 + 1, side / 16 + 1);
  for (float& s : shade) s = 55.0f + 20.0f * random.uniform();
  Image<V3f> image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int row = y / 16;
      const int along = wrap(x + row % 2 * 16, side);
      const bool mortar = y % 16 < 3 || along % 32 < 3;
      image(x, y) = V3f(mortar ? 20.0f : shade(along / 32, row), 0, 0);
    }
  return image;
}

TEST(TranslationLattice, OfBricksIsTheirBond) {
  const auto lattice = find_lattice(bricks(256));
  ASSERT_TRUE(lattice.has_value());
  EXPECT_GT(lattice->correlation, 0.4);
  for (const V2i& t : lattice->translations) {
    EXPECT_EQ(wrap(t.y, 16), 0) << t;
    EXPECT_EQ(wrap(t.x + wrap(t.y / 16, 2) * 16, 32), 0) << t;
  }
  // All places of the bond but the identity: 256 / 32 in a row, 256 / 16 rows.
  EXPECT_EQ(lattice->translations.size(), 127u);
}

TEST(TranslationLattice, GrainHasNone) {
  Random random(1);
  Image<V3f> image(128, 128);
  for (V3f& c : image) c = V3f(random.uniform() * 100.0f, 0, 0);
  EXPECT_FALSE(find_lattice(image).has_value());
}

TEST(TranslationLattice, ADetailCopiedOnceIsNone) {
  Random random(1);
  Image<V3f> image(128, 128);
  for (V3f& c : image) c = V3f(random.uniform() * 100.0f, 0, 0);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 50; ++x) image(x + 60, y + 10) = image(x, y);
  EXPECT_FALSE(find_lattice(image).has_value());
}

TEST(TranslationLattice, AConstantHasNone) {
  EXPECT_FALSE(find_lattice(Image<V3f>(64, 64, V3f(50, 1, 1))).has_value());
}

TEST(TranslationLattice, NearIsAroundEachOfItsTranslations) {
  const Image<uint8_t> near = near_lattice({{V2i(-8, 0), V2i(4, 4)}, 1}, {16, 16}, 1);
  int count = 0;
  for (const uint8_t n : near) count += n;
  EXPECT_EQ(count, 18);
  EXPECT_EQ(near(8, 15), 1);
  EXPECT_EQ(near(5, 5), 1);
  EXPECT_EQ(near(6, 5), 0);
}

}  // namespace
}  // namespace texbake
