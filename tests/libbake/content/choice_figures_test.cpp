#include "libbake/content/choice_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

constexpr int kFiguresSize = 128;

Image<V3f> wave_along_x() {
  Image<V3f> image(kFiguresSize, kFiguresSize);
  for (int y = 0; y < kFiguresSize; ++y)
    for (int x = 0; x < kFiguresSize; ++x)
      image(x, y) = V3f(40.0f, 5.0f, 10.0f * static_cast<float>(std::cos(2.0 * M_PI * x / kFiguresSize)));
  return image;
}

TEST(ChoiceFigures, TheIdentityAloneIsPeriodicAndUsesEveryTexelOnce) {
  const ContentTable table = twin::table(5, {V2i(0, 0)});
  const ChoiceFigures figures =
      choice_figures(table, wave_along_x(), twin::partition(twin::random_patches(kFiguresSize, kFiguresSize, 5, 1), 5));
  EXPECT_NEAR(figures.repetition_near, 1.0, 1e-12);
  EXPECT_NEAR(figures.repetition_far, 1.0, 1e-12);
  EXPECT_EQ(figures.use_deviation, 0.0);
}

TEST(ChoiceFigures, ContentsThatCancelLeaveNothingThatRepeats) {
  const ContentTable table = twin::table(5, {V2i(0, 0), V2i(kFiguresSize / 2, 0)});
  const ChoiceFigures figures =
      choice_figures(table, wave_along_x(), twin::partition(twin::random_patches(kFiguresSize, kFiguresSize, 5, 1), 5));
  EXPECT_NEAR(figures.repetition_near, 0.0, 1e-9);
  EXPECT_NEAR(figures.repetition_far, 0.0, 1e-9);
}

TEST(ChoiceFigures, HalfAPeriodOutOfPhaseRepeatsByHalf) {
  // cos x and cos(x + π/2): the mean has half of the energy.
  const ContentTable table = twin::table(1, {V2i(0, 0), V2i(kFiguresSize / 4, 0)});
  const ChoiceFigures figures =
      choice_figures(table, wave_along_x(), twin::partition(Image<uint32_t>(kFiguresSize, kFiguresSize), 1));
  EXPECT_NEAR(figures.repetition_near, 0.5, 1e-6);  // float sums
  EXPECT_NEAR(figures.repetition_far, 0.5, 1e-6);
}

TEST(ChoiceFigures, UseDeviationCountsHowOftenTexelsAppear) {
  // Left half 0, right half 1; both contents of 1 show the left half: its texels appear 2 + 2 times of a mean of 2.
  Image<uint32_t> patches(kFiguresSize, kFiguresSize);
  for (int y = 0; y < kFiguresSize; ++y)
    for (int x = kFiguresSize / 2; x < kFiguresSize; ++x) patches(x, y) = 1;
  const ContentTable table =
      twin::table({{V2i(0, 0), V2i(0, 5)}, {V2i(kFiguresSize / 2, 0), V2i(kFiguresSize / 2, 9)}});
  EXPECT_NEAR(choice_figures(table, wave_along_x(), twin::partition(std::move(patches), 2)).use_deviation, 1.0, 1e-12);
}

TEST(ChoiceFigures, AQuarterTurnLeavesHalfOfAWave) {
  // A wave along x and, turned, the same along y: z of both is 10 cos, independent of each other over a whole patch.
  Partition patches = twin::partition(Image<uint32_t>(kFiguresSize, kFiguresSize), 1);
  ContentTable table{1, 2, {Content{}, make_content({0, 0}, 2, 1.0f)}};
  const ChoiceFigures figures = choice_figures(table, wave_along_x(), patches);
  EXPECT_NEAR(figures.repetition_near, 0.5, 1e-6);  // float sums
  EXPECT_NEAR(figures.repetition_far, 0.5, 1e-3);   // cells of 2 px
  EXPECT_EQ(figures.use_deviation, 0.0);
}

}  // namespace
}  // namespace texbake
