#include "libbake/content/pair_impact.h"

#include <gtest/gtest.h>

#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

struct PairFixture {
  Image<uint8_t> classes = twin::random_classes(48, 40, 5, 2);
  ClassDistances distances = class_distances(twin::random_colors(5, 2));
  Partition patches = twin::partition(twin::random_patches(48, 40, 4, 2), 4);
};

TEST(PairImpact, IsNothingWhereAllPatchesMoveTogether) {
  const PairFixture f;
  const ContentTable same = twin::table(4, {V2i(11, 7)});
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
  const PairImpact pairs = pair_impact(classes, class_distances(colors), twin::partition(std::move(patches), 2),
                                       twin::table({{V2i(0, 0)}, {V2i(4, 0)}}));
  // δ is not 0 at (8, 8), in the band, and at (4, 8), out of the band and out of sight: E = 100². Both borders of the
  // two patches make one band of 12 columns.
  EXPECT_NEAR(pairs.mean, 100.0 * 100.0 / (12 * 16), 1e-9);
  EXPECT_NEAR(pairs.worst, pairs.mean, 1e-9);
}

TEST(PairImpact, IsTheMeanAndTheWorstOfAllPairs) {
  const PairFixture f;
  double sum = 0.0, worst = 0.0;
  const std::vector<V2i> contents = {V2i(0, 0), V2i(13, 5), V2i(20, 31)};
  // Two patches only: every pair on its own.
  Image<uint32_t> halves(48, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 24; x < 48; ++x) halves(x, y) = 1;
  const Partition patches = twin::partition(std::move(halves), 2);
  for (const V2i& a : contents)
    for (const V2i& b : contents) {
      const PairImpact pair = pair_impact(f.classes, f.distances, patches, twin::table({{a}, {b}}));
      EXPECT_EQ(pair.mean, pair.worst);
      sum += pair.mean;
      worst = std::max(worst, pair.worst);
    }
  const PairImpact all = pair_impact(f.classes, f.distances, patches, twin::table({contents, contents}));
  EXPECT_NEAR(all.mean, sum / 9, 1e-9 * sum);
  EXPECT_EQ(all.worst, worst);
}

TEST(PairImpact, SeesContentsThatAreTurned) {
  // A class for each half of the plane, left and right of the patches' centers; half a turn swaps them. Patches of
  // 8 × 8 texels.
  Image<uint8_t> classes(32, 32);
  Image<uint32_t> squares(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      classes(x, y) = x % 8 < 4 ? 0 : 1;
      squares(x, y) = static_cast<uint32_t>(y / 8 * 4 + x / 8);
    }
  Partition patches = twin::partition(std::move(squares), 16);
  for (int i = 0; i < 16; ++i) patches.centers[static_cast<size_t>(i)] = {i % 4 * 8 + 4, i / 4 * 8 + 4};
  const V3f colors[] = {{0, 0, 0}, {10, 0, 0}};
  // Half a turn about texel 4 takes column 4 + d to 4 − d: moved by one column less, class 0 and 1 change places.
  const Content turned = make_content({-1, 0}, 4, 1.0f);
  ContentTable table{16, 1, std::vector<Content>(16)};
  EXPECT_EQ(pair_impact(classes, class_distances(colors), patches, table).worst, 0.0);
  // Both sides turned fit again; one of them does not: all of the mask differs everywhere.
  for (Content& content : table.contents) content = turned;
  EXPECT_EQ(pair_impact(classes, class_distances(colors), patches, table).worst, 0.0);
  table.contents[5] = Content{};
  EXPECT_NEAR(pair_impact(classes, class_distances(colors), patches, table).worst, 49 * 100.0 * 100.0, 1e-6);
}

}  // namespace
}  // namespace texbake
