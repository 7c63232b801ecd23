#include "libbake/gl/stack_parity.h"

#include <gtest/gtest.h>

#include "gl_test_context.h"
#include "libbake/planes/stack_levels.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

class StackParity : public testing::TestWithParam<ShaderLanguage> {
 protected:
  void SetUp() override {
    context_ = test_context(GetParam());
    if (!context_) GTEST_SKIP() << "no OpenGL";
  }
  void expect_equal(const SmallStack& stack, int windows = 16) {
    StackPlanes planes = stack.planes();
    const ParityReport report = check_stack_parity(planes, *context_, {.windows = windows, .side = 128});
    EXPECT_EQ(report.differing_decisions, 0u) << report.driver;
    EXPECT_EQ(report.differing_bits, 0u) << report.driver;
  }
  std::unique_ptr<GlContext> context_;
};

TEST_P(StackParity, ColorsOfFragmentsDifferInNoBit) { expect_equal(two_scales({.ratio = 5}, Contents::turned)); }

TEST_P(StackParity, ColorsOfTexelsDifferInNoBit) {
  expect_equal(two_scales({.ratio = 16, .mode = TransferMode::texel, .detail_mean = DetailMean::local}));
}

TEST_P(StackParity, SoftlyTakenColorsDifferInNoBit) {
  expect_equal(two_scales({.ratio = 7, .mode = TransferMode::bilinear}));
}

TEST_P(StackParity, WeightsAndGainsDifferInNoBit) {
  expect_equal(two_scales({.ratio = 4,
                           .variation = VariationFrom::fine,
                           .weights = {0.3f, 1},
                           .coarse_weights = {1, 0.7f},
                           .detail_gains = {1.7f, 0.4f}},
                          Contents::turned));
}

TEST_P(StackParity, ThreeScalesDifferInNoBit) {
  SmallStack stack = two_scales({.ratio = 3}, Contents::turned);
  stack.add(random_scale({48, 40}, 5, Contents::moved, 8), {.ratio = 6, .detail_mean = DetailMean::local});
  expect_equal(stack, 24);
}

TEST_P(StackParity, SoftBordersDifferInNoBit) {
  for (const TransferMode mode : {TransferMode::fragment, TransferMode::texel, TransferMode::bilinear}) {
    SmallStack stack = two_scales({.ratio = 4, .mode = mode, .variation = VariationFrom::fine, .weights = {0.3f, 1}},
                                  Contents::turned);
    stack.add(random_scale({48, 40}, 5, Contents::moved, 9), {.ratio = 6, .detail_mean = DetailMean::local});
    for (ScaleTile& scale : stack.tiles) scale.tile.soft_border_px = 2;
    expect_equal(stack, 12);
  }
}

TEST_P(StackParity, NoiseDiffersInNoBit) {
  const std::pair<TransferMode, int> kinds[] = {
      {TransferMode::fragment, 0}, {TransferMode::fragment, 2}, {TransferMode::texel, 2}, {TransferMode::bilinear, 0}};
  for (const auto& [mode, border_px] : kinds) {
    SmallStack stack = two_scales({.ratio = 6,
                                   .mode = mode,
                                   .detail_mean = DetailMean::local,
                                   .detail = DetailStrength::relative,
                                   .detail_gains = {0.5f, 1.75f}},
                                  Contents::turned);
    add_noise(stack.tiles.back().tile, 4, 16, 10);
    for (ScaleTile& scale : stack.tiles) scale.tile.soft_border_px = border_px;
    expect_equal(stack, 12);
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, StackParity,
                         testing::Values(ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es));

}  // namespace
}  // namespace texbake
