#include "libbake/segment/contrast.h"

#include <gtest/gtest.h>

#include "libbake/color/luv.h"
#include "tests/libbake/segment/ascii.h"

namespace texbake {
namespace {

/// Sixteen squares of 4×4 texels; `step` is the lightness between neighboring squares, in ΔE, `grain` inside them.
struct Checkerboard {
  Image<V3f> base{16, 16};
  FragmentMap map;
};

Checkerboard checkerboard(float step, float grain) {
  Checkerboard board;
  Image<uint32_t> idx(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      idx(x, y) = static_cast<uint32_t>(y / 4 * 4 + x / 4);
      const float l = 50 + ((x / 4 + y / 4) % 2 ? step : 0.0f) + ((x + y) % 2 ? grain : 0.0f);
      board.base(x, y) = linear_from_luv(V3f(l, 0, 0));
    }
  board.map.partition = unwrap(std::move(idx));
  board.map.fragments.resize(16);
  return board;
}

TEST(ContrastReport, MeasuresTheStepAcrossBordersAndTheGrainInside) {
  const auto board = checkerboard(12, 0);
  const auto report = contrast_report(board.base, board.map, 100);
  EXPECT_NEAR(report.border_delta_e, 12, 0.01);  // round trip through linear floats
  EXPECT_NEAR(report.interior_delta_e, 0, 0.01);
  EXPECT_EQ(report.size_limited_share, 0);
  const auto grainy = checkerboard(0, 3);
  EXPECT_NEAR(contrast_report(grainy.base, grainy.map, 100).interior_delta_e, 3, 0.01);
  EXPECT_NEAR(contrast_report(grainy.base, grainy.map, 100).border_delta_e, 3, 0.01);
}

TEST(ContrastReport, FragmentsOfTheGreatestAreaAreSizeLimited) {
  const auto board = checkerboard(12, 0);
  EXPECT_EQ(contrast_report(board.base, board.map, 16).size_limited_share, 1);
  EXPECT_EQ(contrast_report(board.base, board.map, 17).size_limited_share, 0);
}

TEST(LowContrast, IsSaidOfFaintBordersAndOfFragmentsThatOnlyTheirSizeEnded) {
  const auto clear = checkerboard(12, 0), faint = checkerboard(1, 0);
  EXPECT_EQ(low_contrast(contrast_report(clear.base, clear.map, 100)), std::nullopt);
  EXPECT_EQ(low_contrast(contrast_report(faint.base, faint.map, 100)), LowContrast::faint_borders);
  EXPECT_EQ(low_contrast(contrast_report(clear.base, clear.map, 16)), LowContrast::size_limited);
  EXPECT_EQ(low_contrast(contrast_report(faint.base, faint.map, 16)), LowContrast::faint_borders);
}

}  // namespace
}  // namespace texbake
