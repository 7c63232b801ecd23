#include "libbake/content/turned_bound.h"

#include <gtest/gtest.h>

#include "libbake/content/turned_search.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

std::vector<BorderTexel> ring(ImageView<const uint8_t> classes, V2i center) {
  std::vector<BorderTexel> border;
  for (int y = -9; y <= 9; ++y)
    for (int x = -9; x <= 9; ++x) {
      const V2i p = wrap(center + V2i(x, y), {classes.width(), classes.height()});
      if (x * x + y * y >= 49 && x * x + y * y < 81) border.push_back({{x, y}, classes(p.x, p.y)});
    }
  return border;
}

// Σ δ² for the content that brings texel `at` to the center.
double obvious_bound(ImageView<const uint8_t> classes, const ClassDistances& distances,
                     const std::vector<BorderTexel>& border, const Content& turn, V2i at) {
  double sum = 0.0;
  for (const BorderTexel& texel : border) {
    const V2i source = wrap(at + source_offset(turn, texel.offset), {classes.width(), classes.height()});
    const double delta = distances.at(texel.class_idx, classes(source.x, source.y));
    sum += delta * delta;
  }
  return sum;
}

TEST(TurnedBound, IsTheSumOfSquaredDistancesWhereCellsAreTexels) {
  const auto classes = twin::random_classes(40, 30, 5, 7);
  const auto distances = class_distances(twin::random_colors(5, 7));
  const TurnedBound bound(classes, distances);
  ASSERT_EQ(bound.grid().cells, V2i(40, 30));
  const auto border = ring(classes, {11, 19});
  for (const Content& turn : make_turns(8, 3, 0.5f)) {
    if (turn.rotation_eighths >= 4) continue;
    const auto bounds = bound.bounds(border, turn);
    for (const V2i& at : {V2i(0, 0), V2i(39, 3), V2i(17, 29)}) {
      const double expected = obvious_bound(classes, distances, border, turn, at);
      EXPECT_NEAR(bounds[0](at.x, at.y), expected, 1e-4 * expected);  // sums of float
    }
  }
}

TEST(TurnedBound, OfHalfATurnMoreNegatesTheOffsets) {
  const auto classes = twin::random_classes(40, 30, 5, 8);
  const auto distances = class_distances(twin::random_colors(5, 8));
  const TurnedBound bound(classes, distances);
  const auto border = ring(classes, {11, 19});
  for (const int eighths : {0, 2}) {
    const auto bounds = bound.bounds(border, make_content({0, 0}, eighths, 1.0f));
    for (const V2i& at : {V2i(5, 5), V2i(38, 0)}) {
      const double expected = obvious_bound(classes, distances, border, make_content({0, 0}, eighths + 4, 1.0f), at);
      EXPECT_NEAR(bounds[1](at.x, at.y), expected, 1e-4 * expected);
    }
  }
}

TEST(TurnedBound, LargeTilesHaveCellsOfSeveralTexels) {
  // Stripes of 64 px are stripes of 32 cells; a border of one texel of class 0 costs δ² where it meets class 1.
  Image<uint8_t> classes(512, 256);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) classes(x, y) = x / 64 % 2 == 0 ? 0 : 1;
  const V3f colors[] = {{0, 0, 0}, {10, 0, 0}};
  const TurnedBound bound(classes, class_distances(colors));
  EXPECT_EQ(bound.grid().cells, V2i(256, 128));
  const std::vector<BorderTexel> border = {{{20, 0}, 0}};
  const auto bounds = bound.bounds(border, Content{});
  for (int x = 0; x < 256; ++x) EXPECT_NEAR(bounds[0](x, 9), (x + 10) / 32 % 2 == 0 ? 0.0 : 255.0 * 255.0, 10.0) << x;
}

}  // namespace
}  // namespace texbake
