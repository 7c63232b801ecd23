#include "libbake/gl/perspective_parity.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "gl_test_context.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/stack_levels.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

TEST(PerspectiveParity, TheShaderSeesTheSamePlane) {
  SmallTile tile = random_tile({64, 128}, 5, Contents::turned, 11);
  add_noise(tile, 3, 32, 11);
  const Image<float> gray(64, 128, 0.25f);
  EvaluatorInput input = tile.input();
  input.maps.push_back({"height", MapKind::height, {gray}});
  EvaluatorPlanes planes = prepare(input);
  for (const ShaderLanguage language : {ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es}) {
    const auto context = test_context(language);
    if (!context) GTEST_SKIP() << "no OpenGL";
    const PerspectiveParity parity = check_perspective_parity(planes, *context);
    std::printf("%llu sights differ\n", static_cast<unsigned long long>(parity.differing_sights));
    EXPECT_TRUE(parity.equal()) << parity.differing_sights << " sights, " << parity.differing_values << " values of "
                                << parity.pixels << " on " << context->description();
  }
}

TEST(PerspectiveParity, TheShaderSeesTheSameStack) {
  SmallStack stack = two_scales({.ratio = 5}, Contents::turned);
  stack.add(random_scale({48, 40}, 5, Contents::moved, 8), {.ratio = 8, .detail_mean = DetailMean::local});
  StackPlanes planes = stack.planes();
  for (const ShaderLanguage language : {ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es}) {
    const auto context = test_context(language);
    if (!context) GTEST_SKIP() << "no OpenGL";
    const PerspectiveParity parity = check_stack_perspective_parity(planes, nullptr, *context);
    std::printf("%llu sights of a stack differ\n", static_cast<unsigned long long>(parity.differing_sights));
    EXPECT_TRUE(parity.equal()) << parity.differing_sights << " sights, " << parity.differing_values << " values of "
                                << parity.pixels << " on " << context->description();
  }
}

TEST(PerspectiveParity, TheShaderSeesTheSameRelief) {
  SmallStack stack = two_scales({.ratio = 5}, Contents::turned);
  for (ScaleTile& scale : stack.tiles) scale.tile.soft_border_px = 2;
  StackPlanes planes = stack.planes();
  // Waves of height, and normals that need not be theirs.
  Image<float> height(32, 16), normal[3] = {{32, 16}, {32, 16}, {32, 16}};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      height(x, y) = static_cast<float>((x * 3 + y * 5) % 16) / 16;
      normal[0](x, y) = static_cast<float>(x % 5 - 2) / 4;
      normal[1](x, y) = static_cast<float>(y % 3 - 1) / 4;
      normal[2](x, y) = 0.75f;
    }
  EvaluatorInput input = stack.tiles.front().input();
  input.maps.push_back({"height", MapKind::height, {height}});
  input.maps.push_back({"normal", MapKind::normal_opengl, {normal[0], normal[1], normal[2]}});
  for (const ShadeBy shade_by : {ShadeBy::height, ShadeBy::normal}) {
    const ReliefPlanes relief = relief_planes(input, {.depth_px = 3, .shade_by = shade_by}, {-1, -0.5f, 1});
    for (const ShaderLanguage language : {ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es}) {
      const auto context = test_context(language);
      if (!context) GTEST_SKIP() << "no OpenGL";
      const PerspectiveParity parity = check_stack_perspective_parity(planes, &relief, *context);
      std::printf("%llu sights of relief differ\n", static_cast<unsigned long long>(parity.differing_sights));
      EXPECT_TRUE(parity.equal()) << parity.differing_sights << " sights, " << parity.differing_values << " values of "
                                  << parity.pixels << " on " << context->description();
      const PerspectiveParity windows = check_relief_parity(planes, relief, *context);
      std::printf("%llu sights of windows with relief differ\n",
                  static_cast<unsigned long long>(windows.differing_sights));
      EXPECT_TRUE(windows.equal()) << windows.differing_sights << " sights, " << windows.differing_values
                                   << " values of " << windows.pixels << " on " << context->description();
    }
  }
}

TEST(PerspectiveParity, RowsOfAViewAreThoseOfTheWhole) {
  const auto context = test_context(ShaderLanguage::glsl_330);
  if (!context) GTEST_SKIP() << "no OpenGL";
  EvaluatorPlanes planes = random_tile({32, 32}, 3, Contents::moved, 12).planes();
  GlRenderer renderer(*context, planes, perspective_fragment_shader(ShaderLanguage::glsl_330));
  Perspective view;
  view.width = 50;
  view.height = 40;
  const Frame whole = renderer.draw(view, planes.base), part = renderer.draw(view, planes.base, 13, 27);
  EXPECT_TRUE(std::equal(part.values.begin(), part.values.end(), whole.values.row(13)));
}

}  // namespace
}  // namespace texbake
