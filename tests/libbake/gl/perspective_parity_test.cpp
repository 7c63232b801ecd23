#include "libbake/gl/perspective_parity.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "gl_test_context.h"
#include "libbake/eval/levels.h"
#include "tests/libbake/eval/small_tile.h"

namespace texbake {
namespace {

TEST(PerspectiveParity, TheShaderSeesTheSamePlane) {
  SmallTile tile = random_tile({64, 128}, 5, Contents::turned, 11);
  add_noise(tile, 3, 32, 11);
  const Image<float> grey(64, 128, 0.25f);
  EvaluatorInput input = tile.input();
  input.maps.push_back({"height", MapKind::height, {grey}});
  EvaluatorPlanes planes = prepare(input);
  add_levels(planes);
  for (const ShaderLanguage language : {ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es}) {
    const auto context = test_context(language);
    if (!context) GTEST_SKIP() << "no OpenGL";
    const PerspectiveParity parity = check_perspective_parity(planes, *context);
    std::printf("%llu sights differ\n", static_cast<unsigned long long>(parity.differing_sights));
    EXPECT_TRUE(parity.equal()) << parity.differing_sights << " sights, " << parity.differing_values << " values of "
                                << parity.pixels << " on " << context->description();
  }
}

TEST(PerspectiveParity, RowsOfAViewAreThoseOfTheWhole) {
  const auto context = test_context(ShaderLanguage::glsl_330);
  if (!context) GTEST_SKIP() << "no OpenGL";
  EvaluatorPlanes planes = random_tile({32, 32}, 3, Contents::moved, 12).planes();
  add_levels(planes);
  GlRenderer renderer(*context, planes, perspective_fragment_shader(ShaderLanguage::glsl_330));
  Perspective view;
  view.width = 50;
  view.height = 40;
  const Frame whole = renderer.draw(view, planes.base), part = renderer.draw(view, planes.base, 13, 27);
  EXPECT_TRUE(std::equal(part.values.begin(), part.values.end(), whole.values.row(13)));
}

}  // namespace
}  // namespace texbake
