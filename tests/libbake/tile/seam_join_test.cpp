#include "libbake/tile/seam_join.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/libbake/color/torus_noise.h"

namespace texbake {
namespace {

// A cut that wanders through a strip of 20 columns, the rows of a ring.
Seam wandering_seam(int rows, CutEnds ends) {
  Seam seam{.begin = 3, .period = 40, .overlap = 20, .ends = ends, .column = {}};
  for (int y = 0; y < rows; ++y) seam.column.push_back(10 + (y % 8 < 4 ? y % 4 : -(y % 4)));
  return seam;
}

float shown_hard(const Image<float>& image, const Seam& seam, int x, int y) {
  return image(seam.begin + x + (x < seam.column[y] ? seam.period : 0), y);
}

TEST(SeamJoin, RepetitionIsJoinedExactly) {
  const Image<V3f> tile = torus_noise(40, 24, 1, 1);
  const Image<V3f> image = window_of(tile, {0, 0}, 70, 24);
  for (const CutEnds ends : {CutEnds::open, CutEnds::closed})
    EXPECT_EQ(join_along_x(image, wandering_seam(24, ends)), window_of(tile, {3, 0}, 40, 24));
}

TEST(SeamJoin, ConstantDifferenceIsSpreadHalfAndHalf) {
  // grain that repeats, and a shade that is 0.2 brighter further on
  Image<float> image(70, 24);
  Random random(2);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 70; ++x) image(x, y) = x < 40 ? 0.3f + 0.1f * random.uniform() : image(x - 40, y) + 0.2f;
  const Seam seam = wandering_seam(24, CutEnds::closed);
  const Image<float> joined = join_along_x(image, seam);
  for (int y = 0; y < 24; ++y) {
    const int x = seam.column[y];
    const float grain = image(seam.begin + x, y) - image(seam.begin + x - 1, y);
    EXPECT_NEAR(joined(x, y) - joined(x - 1, y), grain, 0.03f) << y;  // σ = 4: one texel of its slope is 0.2 / 10
    EXPECT_NEAR(joined(19, y), shown_hard(image, seam, 19, y), 0.01f);
    EXPECT_EQ(joined(20, y), shown_hard(image, seam, 20, y));
  }
}

TEST(SeamJoin, ErrorsThatCancelAreLeftAlone) {
  // differences of ± 0.2 in alternating rows: no shade, and nothing to level
  Image<float> image(70, 24, 0.5f);
  for (int y = 0; y < 24; ++y)
    for (int x = 40; x < 70; ++x) image(x, y) += y % 2 ? 0.2f : -0.2f;
  Seam seam = wandering_seam(24, CutEnds::closed);
  seam.column.assign(24, 10);
  const Image<float> joined = join_along_x(image, seam);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 40; ++x) ASSERT_NEAR(joined(x, y), shown_hard(image, seam, x, y), 1e-3f);
}

TEST(SeamJoin, ClosedStripHasNoFirstRow) {
  const Image<V3f> image = torus_noise(70, 24, 2, 3);
  const Seam seam = wandering_seam(24, CutEnds::closed);
  Seam turned = seam;
  std::rotate(turned.column.begin(), turned.column.begin() + 5, turned.column.end());
  const Image<V3f> joined = join_along_x(image, seam);
  const Image<V3f> joined_turned = join_along_x(window_of(image, {0, 5}, 70, 24), turned);
  EXPECT_EQ(joined_turned, window_of(joined, {0, 5}, 40, 24));
}

TEST(SeamJoin, ValuesStayInTheirRange) {
  Image<float> image(70, 24);
  Random random(4);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 70; ++x) image(x, y) = x < 40 ? 0.0f : random.uniform() < 0.5f ? 1.0f : 0.0f;
  for (const float value : join_along_x(image, wandering_seam(24, CutEnds::open))) {
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
  }
}

}  // namespace
}  // namespace texbake
