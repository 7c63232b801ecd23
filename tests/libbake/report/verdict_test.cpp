#include "libbake/report/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbake {
namespace {

TEST(Verdict, FollowsTheLimits) {
  const Limits band = *limits_of(Measure::band_fine, 5);
  EXPECT_EQ(judge(band, Measured::of(1.0)), Verdict::pass);
  EXPECT_EQ(judge(band, Measured::of(0.85)), Verdict::warn);
  EXPECT_EQ(judge(band, Measured::of(1.2)), Verdict::warn);
  EXPECT_EQ(judge(band, Measured::of(0.5)), Verdict::fail);
  EXPECT_EQ(judge(band, Measured::of(2.0)), Verdict::fail);
}

TEST(Verdict, WhatIsNotThereIsNeverGood) {
  const Limits limits = *limits_of(Measure::repetition_far, 5);
  EXPECT_EQ(judge(limits, Measured::undefined("why")), Verdict::undefined);
  EXPECT_EQ(judge(limits, Measured::of(std::nan(""))), Verdict::undefined);
  EXPECT_EQ(worst({Verdict::pass, Verdict::undefined, Verdict::warn}), Verdict::undefined);
  EXPECT_EQ(worst({Verdict::undefined, Verdict::fail}), Verdict::fail);
}

TEST(Verdict, NearRepetitionMayBeOneContentsShare) {
  EXPECT_EQ(judge(*limits_of(Measure::repetition_near, 5), Measured::of(0.22)), Verdict::pass);
  EXPECT_EQ(judge(*limits_of(Measure::repetition_near, 8), Measured::of(0.22)), Verdict::warn);
}

TEST(Verdict, EveryJudgedMeasureSaysWhatToTry) {
  for (const MeasureKind& kind : measure_kinds()) {
    EXPECT_FALSE(kind.meaning.empty()) << kind.key;
    EXPECT_EQ(limits_of(kind.measure, 5).has_value(), !kind.advice.empty()) << kind.key;
  }
}

TEST(Verdict, GoodIsSaidInWords) {
  EXPECT_EQ(good_text(*limits_of(Measure::repetition_far, 5)), "≤ 0.1");
  EXPECT_EQ(good_text(*limits_of(Measure::gradient_ratio, 5)), "0.96 - 1.05");
}

}  // namespace
}  // namespace texbake
