#include "libbake/report/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kStep = 1e-9;  // far below the last digit of a limit, far above rounding

/// The limits of a measure: good from `pass_low` to `pass_high`, doubtful from `warn_low` to `warn_high`. What is good
/// follows from the tables of measures on photographs, except for the drop of coherence, which is allowed a little more
/// than the 0.03 at which decompose begins to warn; what is doubtful was chosen by looking at photographs.
struct Expected {
  Measure measure;
  double pass_low, pass_high, warn_low, warn_high;
};

constexpr Expected kHard[] = {
    {Measure::tile_x, -kNone, 1.15, -kNone, 1.5},
    {Measure::tile_y, -kNone, 1.15, -kNone, 1.5},
    {Measure::repetition_near, -kNone, 0.2 + 0.03, -kNone, 0.2 + 0.10},  // five contents: 1/5
    {Measure::repetition_far, -kNone, 0.10, -kNone, 0.20},
    {Measure::amplitude_far, -kNone, 0.7, -kNone, 1.4},
    {Measure::band_finest, 0.9, 1.1, 0.8, 1.25},
    {Measure::band_fine, 0.9, 1.1, 0.8, 1.25},
    {Measure::band_middle, 0.9, 1.1, 0.8, 1.25},
    {Measure::band_coarse, 0.9, 1.1, 0.8, 1.25},
    {Measure::band_rest, 0.9, 1.1, 0.8, 1.25},
    {Measure::seam_auc, -kNone, 0.65, -kNone, 0.72},
    {Measure::seam_tail, -kNone, 0.10, -kNone, 0.20},
    {Measure::color, -kNone, 0.06, -kNone, 0.10},
    {Measure::spectrum, -kNone, 0.8, -kNone, 1.5},
    {Measure::gradient_ratio, 0.96, 1.05, 0.90, 1.12},
    {Measure::structure, -kNone, 1.15, -kNone, 1.4},
    {Measure::noise_spectrum, -kNone, 1.0, -kNone, 2.0},
    {Measure::noise_power, -kNone, 0.03, -kNone, 0.06},
    {Measure::noise_coherence, -kNone, 0.05, -kNone, 0.10},
};

void expect_limits(const Expected& expected, const Limits& limits) {
  const auto verdict = [&](double value) { return judge(limits, Measured::of(value)); };
  const std::string_view key = kind_of(expected.measure).key;
  EXPECT_EQ(verdict(expected.pass_high - kStep), Verdict::pass) << key;
  EXPECT_EQ(verdict(expected.pass_high + kStep), Verdict::warn) << key;
  EXPECT_EQ(verdict(expected.warn_high - kStep), Verdict::warn) << key;
  EXPECT_EQ(verdict(expected.warn_high + kStep), Verdict::fail) << key;
  if (expected.pass_low == -kNone) {
    EXPECT_EQ(verdict(-1e6), Verdict::pass) << key << ": the less, the better";
    return;
  }
  EXPECT_EQ(verdict(expected.pass_low + kStep), Verdict::pass) << key;
  EXPECT_EQ(verdict(expected.pass_low - kStep), Verdict::warn) << key;
  EXPECT_EQ(verdict(expected.warn_low + kStep), Verdict::warn) << key;
  EXPECT_EQ(verdict(expected.warn_low - kStep), Verdict::fail) << key;
}

TEST(Verdict, EveryLimitIsWhereItIsSaidToBe) {
  for (const Expected& expected : kHard) expect_limits(expected, *limits_of(expected.measure, 5));
}

TEST(Verdict, EveryJudgedMeasureHasItsLimitsPinned) {
  for (const MeasureKind& kind : measure_kinds())
    EXPECT_EQ(std::ranges::count(kHard, kind.measure, &Expected::measure), limits_of(kind.measure, 5) ? 1 : 0)
        << kind.key;
}

TEST(Verdict, SoftBordersMustHideSeamsBetterAndChangeNothingElse) {
  for (Expected expected : kHard) {
    if (expected.measure == Measure::seam_auc) expected = {Measure::seam_auc, -kNone, 0.60, -kNone, 0.67};
    expect_limits(expected, *limits_of(expected.measure, 5, 1));
  }
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
