#include "libbake/tile/period_search.h"

#include <gtest/gtest.h>

#include "libbake/color/luv.h"
#include "tests/libbake/color/torus_noise.h"

namespace texbake {
namespace {

TEST(PeriodSearch, FindsThePlantedPeriodWhateverTheMultiple) {
  const Image<V3f> luv = luv_from_linear(window_of(torus_noise(151, 90, 2, 3), {17, 5}, 200, 90));
  for (const int multiple : {1, 16, 64}) {
    const Period period = best_period(luv, {multiple, {}});
    EXPECT_EQ(period.length, 151) << multiple;
    EXPECT_EQ(period.cost, 0) << multiple;
    EXPECT_EQ(period.overlap, 49) << multiple;
  }
}

TEST(PeriodSearch, FindsAPlantedPeriodThatIsLongerThanTheSearchSide) {
  const Image<V3f> luv = luv_from_linear(window_of(torus_noise(613, 64, 3, 4), {100, 0}, 800, 64));
  EXPECT_EQ(best_period(luv, {64, {}}).length, 613);
}

TEST(PeriodSearch, BandsOfAFewRowsAreSearched) {
  const Image<V3f> luv = luv_from_linear(window_of(torus_noise(6000, 32, 3, 4), {100, 0}, 9000, 32));
  EXPECT_EQ(best_period(luv, {64, {}}).length, 6000);
}

TEST(PeriodSearch, WithoutAPatternThePeriodIsAMultiple) {
  const Image<V3f> luv = luv_from_linear(torus_noise(200, 120, 2, 5));
  const Period period = best_period(luv, {16, {}});
  EXPECT_EQ(period.length % 16, 0);
  EXPECT_GE(period.length, 100);
  EXPECT_LE(period.length, 188);  // a sixteenth is left for the overlap
  EXPECT_EQ(period.overlap, std::min(200 - period.length, period.length));
}

TEST(PeriodSearch, GivenOverlapIsKept) {
  const Image<V3f> luv = luv_from_linear(torus_noise(200, 120, 2, 5));
  const Period period = best_period(luv, {16, 30});
  EXPECT_EQ(period.overlap, 30);
  EXPECT_EQ(period.length % 16, 0);
  EXPECT_LE(period.length + 30, 200);
}

TEST(PeriodSearch, MultipleIsHalvedUntilItFits) {
  EXPECT_EQ(multiple_within(64, 256, 480), 64);
  EXPECT_EQ(multiple_within(64, 40, 60), 16);
  EXPECT_EQ(multiple_within(64, 17, 17), 1);
  EXPECT_EQ(multiple_within(24, 10, 11), 1);  // 24, 12, 6, 3, then 1
}

TEST(PeriodSearch, MismatchIsZeroWhereThePictureRepeats) {
  const Image<V3f> luv = luv_from_linear(window_of(torus_noise(40, 30, 1, 6), {0, 0}, 64, 30));
  for (const float value : overlap_mismatch(luv, 0, 40, 20)) EXPECT_EQ(value, 0);  // column 63 has one neighbor less
  double sum = 0;
  for (const float value : overlap_mismatch(luv, 0, 37, 20)) sum += value;
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace texbake
