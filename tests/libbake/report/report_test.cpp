#include "libbake/report/report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/color/luv.h"
#include "libbake/report/rendering_measures.h"
#include "libbake/report/report_input.h"
#include "tests/libbake/report/tile_fixture.h"

namespace texbake {
namespace {

ReportOptions small_options() { return {.seeds = 1, .tiles = 4, .side_px = 64}; }

Report report_on(const TileFixture& fixture) {
  ReportInput input;
  input.tile = fixture.input();
  return report(input, small_options());
}

double value(const Report& report, Method method, Measure measure) {
  const Measured& measured = report.of(method)[measure];
  EXPECT_TRUE(measured.value.has_value()) << kind_of(measure).key << ": " << measured.undefined_because;
  return measured.value ? measured.value->mean : NAN;
}

TEST(Report, PeriodicTilingRepeatsWhollyAndMatchesItself) {
  const Report found = report_on(tile_fixture(32, 4));
  EXPECT_NEAR(value(found, Method::periodic, Measure::repetition_near), 1.0, 1e-4);
  EXPECT_NEAR(value(found, Method::periodic, Measure::repetition_far), 1.0, 1e-4);
  EXPECT_NEAR(value(found, Method::periodic, Measure::seam_auc), 0.5, 1e-9);
  EXPECT_NEAR(value(found, Method::periodic, Measure::band_coarse), 1.0, 1e-3);
  EXPECT_NEAR(value(found, Method::periodic, Measure::color), 0.0, 1e-6);
  EXPECT_NEAR(value(found, Method::periodic, Measure::gradient_ratio), 1.0, 0.05);  // the wrap counts beside the inside
  EXPECT_NEAR(value(found, Method::periodic, Measure::structure), 1.0, 0.1);        // medians of other windows
}

TEST(Report, HexTilingHasNoSeamAndSaysWhy) {
  const Report found = report_on(tile_fixture(32, 4));
  EXPECT_FALSE(found.of(Method::hex)[Measure::seam_auc].value.has_value());
  EXPECT_NE(found.of(Method::hex)[Measure::seam_auc].undefined_because, "");
}

TEST(Report, MoreContentsRepeatLessAndThePredictionKnows) {
  const Report two = report_on(tile_fixture(32, 2));
  const Report eight = report_on(tile_fixture(32, 8));
  EXPECT_GT(value(two, Method::bundle, Measure::repetition_near),
            value(eight, Method::bundle, Measure::repetition_near) + 0.1);
  // 16 tiles leave the measured share uncertain by about 1/16.
  for (const Report* found : {&two, &eight})
    EXPECT_NEAR(value(*found, Method::bundle, Measure::repetition_near),
                value(*found, Method::bundle, Measure::predicted_near), 0.07);
}

TEST(Report, WithoutContentsNothingOfTheBundleIsDefinedAndNothingPasses) {
  TileFixture fixture = tile_fixture(32, 2);
  ReportInput input;
  input.tile = fixture.input();
  input.tile.contents = nullptr;
  const Report found = report(input, small_options());
  EXPECT_EQ(found.verdict, Verdict::undefined);
  EXPECT_NE(found.of(Method::bundle)[Measure::repetition_far].undefined_because.find("select-contents"),
            std::string::npos);
  EXPECT_NEAR(value(found, Method::periodic, Measure::repetition_near), 1.0, 1e-4);
}

TEST(Report, OfOneColorIsNotDefinedAndNeverPasses) {
  TileFixture fixture = tile_fixture(32, 3);
  fixture.base = Image<V3f>(32, 32, V3f(0.25f, 0.5f, 0.125f));
  const Report found = report_on(fixture);
  EXPECT_EQ(found.verdict, Verdict::undefined);
  for (const MeasureRow& row : found.methods)
    for (const MeasureKind& kind : measure_kinds()) {
      const auto& found_value = row[kind.measure].value;
      EXPECT_TRUE(!found_value || std::isfinite(found_value->mean)) << kind.key;
    }
}

TEST(Report, OfATileTooSmallForASpectrumSaysSo) {
  const TileFixture fixture = tile_fixture(16, 3);
  const Report found = report_on(fixture);
  EXPECT_FALSE(found.of(Method::bundle)[Measure::spectrum].value.has_value());
  EXPECT_NE(found.of(Method::bundle)[Measure::spectrum].undefined_because.find("16 texels"), std::string::npos);
  EXPECT_GE(found.verdict, Verdict::undefined);
}

TEST(Report, JudgesTheNoiseLayerWhereThereIsOneAndPassesNothingThatWasNotRecorded) {
  const TileFixture fixture = tile_fixture(32, 3);
  const Image<float> mask(32, 32, 1.0f);
  const Image<V3f> noise(16, 16, V3f(0.0f));
  const Image<float> spectrum(16, 16, 1.0f);
  ReportInput input;
  input.tile = fixture.input();
  input.tile.noise = NoiseInput{{mask}, {noise}, 161};
  input.exemplar = fixture.base;
  input.noise = NoiseSummary{.spectrum_db = 0.5, .power_error = 0.01, .coherence_drop = 0.2};
  input.spectra.push_back(spectrum);
  const Report found = report(input, small_options());
  const auto verdict = [&](Measure measure) {
    for (const Judgement& judgement : found.judgements)
      if (judgement.measure == measure) return judgement.verdict;
    return Verdict::undefined;
  };
  EXPECT_EQ(verdict(Measure::noise_spectrum), Verdict::pass);
  EXPECT_EQ(verdict(Measure::noise_coherence), Verdict::fail);
  EXPECT_FALSE(found.of(Method::bundle)[Measure::noise_energy].value.has_value());
  EXPECT_NE(found.of(Method::bundle)[Measure::noise_energy].undefined_because, "");
  // A patch, a base, the masks and one noise.
  EXPECT_EQ(value(found, Method::bundle, Measure::fetches), 4);
}

TEST(Report, WithoutANoiseLayerDoesNotJudgeOne) {
  const Report found = report_on(tile_fixture(32, 3));
  for (const Judgement& judgement : found.judgements) EXPECT_NE(kind_of(judgement.measure).group, "Noise");
}

TEST(Report, IsTheSameTwice) {
  const TileFixture fixture = tile_fixture(32, 3);
  const Report a = report_on(fixture), b = report_on(fixture);
  for (const MeasureKind& kind : measure_kinds())
    EXPECT_EQ(
        a.of(Method::bundle)[kind.measure].value.has_value() ? a.of(Method::bundle)[kind.measure].value->mean : 0,
        b.of(Method::bundle)[kind.measure].value.has_value() ? b.of(Method::bundle)[kind.measure].value->mean : 0);
}

TEST(Report, CountsWhatIsFetched) {
  const TileFixture fixture = tile_fixture(32, 3);
  const Report found = report_on(fixture);
  EXPECT_EQ(value(found, Method::bundle, Measure::fetches), 2);
  EXPECT_EQ(value(found, Method::periodic, Measure::fetches), 1);
  EXPECT_EQ(value(found, Method::hex, Measure::fetches), 3);
  // 32 · 32 texels of 8 bytes, of 4 bytes for the patches; 16 patches with 3 contents and a center of 16 bytes each.
  EXPECT_DOUBLE_EQ(value(found, Method::bundle, Measure::gpu_bytes), (1024 * 12 + 16 * 4 * 16) / 1048576.0);
}

TEST(Report, SoftBordersCostMoreWhereTheyAre) {
  const TileFixture fixture = tile_fixture(64, 3);
  ReportInput input;
  input.tile = fixture.input();
  input.tile.soft_border_px = 2;
  const Report found = report(input, small_options());
  // 16 squares of 16 texels, soft one texel deep on each side: 1 − (14/16)² of the texels have two shares, and of these
  // (2/16)² have up to four. A share more costs two fetches.
  EXPECT_GE(value(found, Method::bundle, Measure::fetches), 2 + 2 * (1 - 14.0 * 14 / 256));
  EXPECT_LE(value(found, Method::bundle, Measure::fetches), 2 + 2 * (1 - 14.0 * 14 / 256) + 4 * 4.0 / 256);
}

TEST(Report, SeamsAreMeasuredAtFullSizeWhereTheRestIsReduced) {
  const TileFixture fixture = tile_fixture(64, 3);
  ReportInput input;
  input.tile = fixture.input();
  const Report whole = report(input, {.seeds = 1, .tiles = 2, .side_px = 64});
  const Report reduced = report(input, {.seeds = 1, .tiles = 2, .side_px = 32});
  EXPECT_EQ(reduced.reduction, 2);
  EXPECT_EQ(reduced.seam_reduction, 1);
  EXPECT_EQ(value(reduced, Method::bundle, Measure::seam_auc), value(whole, Method::bundle, Measure::seam_auc));
  EXPECT_NE(value(reduced, Method::bundle, Measure::gradient_ratio),
            value(whole, Method::bundle, Measure::gradient_ratio));
}

TEST(Report, SaysOfEveryMapWhetherItTiles) {
  const TileFixture fixture = tile_fixture(64, 3);
  Image<float> tiles(64, 64), ramp(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      tiles(x, y) = fixture.base(x, y).x;
      ramp(x, y) = static_cast<float>(x);  // 63 steps of 1 inside, one of 63 across the wrap
    }
  ReportInput input;
  input.tile = fixture.input();
  input.tile.maps.push_back({"roughness", MapKind::plain, {tiles}});
  input.tile.maps.push_back({"normal", MapKind::normal_opengl, {tiles, tiles, ramp}});
  const Report found = report(input, small_options());
  ASSERT_EQ(found.maps.size(), 2u);
  EXPECT_EQ(found.maps[0].name, "roughness");
  EXPECT_LT(found.maps[0].tile_x, 1.5);
  EXPECT_LE(found.maps[0].verdict, Verdict::warn);
  EXPECT_GT(found.maps[1].tile_x, 10);
  EXPECT_EQ(found.maps[1].verdict, Verdict::fail);
  EXPECT_EQ(found.verdict, Verdict::fail);
}

TEST(OverSeeds, GivesMeanAndStandardDeviation) {
  std::vector<MeasureRow> rows(2);
  rows[0][Measure::color] = Measured::of(1.0);
  rows[1][Measure::color] = Measured::of(2.0);
  rows[0][Measure::spectrum] = Measured::of(1.0);
  rows[1][Measure::spectrum] = Measured::undefined("why");
  const MeasureRow both = over_seeds(rows);
  EXPECT_DOUBLE_EQ(both[Measure::color].value->mean, 1.5);
  EXPECT_DOUBLE_EQ(both[Measure::color].value->spread, std::sqrt(0.5));
  EXPECT_EQ(both[Measure::spectrum].undefined_because, "why");
}

}  // namespace
}  // namespace texbake
