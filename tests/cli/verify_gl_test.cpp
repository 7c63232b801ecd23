#include "cli/verify_gl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texbake {
namespace {

using testing::HasSubstr;

ParityReport report_with(uint64_t decisions, uint64_t points) {
  ParityReport report;
  report.points = 100;
  report.differing_decisions = decisions;
  report.differing_points = points;
  report.driver = "a driver";
  return report;
}

TEST(VerifyGl, EqualInEveryLanguageIsDone) {
  const Outcome outcome =
      parity_outcome({{GlLanguage::core, {report_with(0, 0)}}, {GlLanguage::es, {report_with(0, 0)}}}, {8, 8});
  EXPECT_EQ(outcome.code, ExitCode::done);
  EXPECT_THAT(outcome.text, HasSubstr("OpenGL ES 3.0 on a driver: equals the processor"));
  EXPECT_EQ(outcome.result["gl"].size(), 2u);
}

TEST(VerifyGl, OneDifferingLanguageIsANo) {
  EXPECT_EQ(
      parity_outcome({{GlLanguage::core, {report_with(0, 0)}}, {GlLanguage::es, {report_with(0, 1)}}}, {8, 8}).code,
      ExitCode::no);
  EXPECT_EQ(parity_outcome({{GlLanguage::core, {report_with(1, 0)}}}, {8, 8}).code, ExitCode::no);
}

TEST(VerifyGl, OnePixelInTwentyMaySeeAnotherPlaceButNoneAnotherValue) {
  const auto code = [](uint64_t sights, uint64_t values) {
    return parity_outcome({{GlLanguage::core, {report_with(0, 0), {1000, sights, values}}}}, {8, 8}).code;
  };
  EXPECT_EQ(code(50, 0), ExitCode::done);
  EXPECT_EQ(code(51, 0), ExitCode::no);
  EXPECT_EQ(code(0, 1), ExitCode::no);
}

TEST(VerifyGl, WhereItDiffersIsAPointOfTheTextureWithBothValues) {
  ParityReport report = report_with(1, 1);
  Window window;
  window.origin_x = {0xffffffffu, 0};
  window.step_256 = 512;
  window.seed = 9;
  report.worst = WorstWindow{window, "normal", {5, 1, V3f(0, 0, 1), V3f(0, 0.5f, 1), 0.5f}};
  report.first_decision = DifferingDecision{window, {0, 0}, {3, 1, 7, 2}, {3, 2, 6, 5}};
  const Outcome outcome = parity_outcome({{GlLanguage::core, report}}, {8, 8});
  // Pixel 5 of two texels each begins 10 texels on: 2 in the tile after the one that wraps to 0, its center one more.
  EXPECT_THAT(outcome.text,
              HasSubstr("worst value: normal at tile (0, 0), texel (3, 3), seed 9, bilinear: expected (0, "
                        "0, 1), found (0, 0.5, 1)"));
  EXPECT_THAT(outcome.text, HasSubstr("first decision: tile (4294967295, 0), texel (1, 1), seed 9, bilinear: expected "
                                      "patch 3 content 1 source (7, 2), found patch 3 content 2 source (6, 5)"));
  EXPECT_EQ(outcome.result["gl"][0]["worst"]["tile"], Json({0, 0}));
}

}  // namespace
}  // namespace texbake
