#include "libbake/content/pair_impact.h"

#include <gtest/gtest.h>

#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

struct Fixture {
  Image<uint8_t> classes = twin::random_classes(48, 40, 5, 2);
  ClassDistances distances = class_distances(twin::random_colors(5, 2));
  Image<uint32_t> patches = twin::random_patches(48, 40, 4, 2);
};

TEST(PairImpact, IsNothingWhereAllPatchesMoveTogether) {
  const Fixture f;
  const std::vector<std::vector<V2i>> same(4, {V2i(11, 7)});
  const PairImpact pairs = pair_impact(f.classes, f.distances, f.patches, same);
  EXPECT_EQ(pairs.mean, 0.0);
  EXPECT_EQ(pairs.worst, 0.0);
}

TEST(PairImpact, ComparesWhatBothSidesShowAlongTheirBorder) {
  // Patches are the left and the right half: borders at columns 7 | 8 and 15 | 0, the texels within 2 of both sides of
  // them are columns 5 … 10 and 13 … 2. The right half shows what lies 4 columns further, there one texel is odd.
  Image<uint8_t> classes(16, 16);
  classes(8, 8) = 1;
  Image<uint32_t> patches(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 8; x < 16; ++x) patches(x, y) = 1;
  const V3f colors[] = {{0, 0, 0}, {10, 0, 0}};  // δ = 100 ΔE²
  const PairImpact pairs = pair_impact(classes, class_distances(colors), patches, {{V2i(0, 0)}, {V2i(4, 0)}});
  // δ is not 0 at (8, 8), in the band, and at (4, 8), out of the band and out of sight: E = 100². Both borders of the
  // two patches make one band of 12 columns.
  EXPECT_NEAR(pairs.mean, 100.0 * 100.0 / (12 * 16), 1e-9);
  EXPECT_NEAR(pairs.worst, pairs.mean, 1e-9);
}

TEST(PairImpact, IsTheMeanAndTheWorstOfAllPairs) {
  const Fixture f;
  std::vector<std::vector<V2i>> one(4, {V2i(0, 0)});
  double sum = 0.0, worst = 0.0;
  const std::vector<V2i> contents = {V2i(0, 0), V2i(13, 5), V2i(20, 31)};
  // Two patches only: every pair on its own.
  Image<uint32_t> halves(48, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 24; x < 48; ++x) halves(x, y) = 1;
  for (const V2i& a : contents)
    for (const V2i& b : contents) {
      const PairImpact pair = pair_impact(f.classes, f.distances, halves, {{a}, {b}});
      EXPECT_EQ(pair.mean, pair.worst);
      sum += pair.mean;
      worst = std::max(worst, pair.worst);
    }
  const PairImpact all = pair_impact(f.classes, f.distances, halves, {contents, contents});
  EXPECT_NEAR(all.mean, sum / 9, 1e-9 * sum);
  EXPECT_EQ(all.worst, worst);
}

}  // namespace
}  // namespace texbake
