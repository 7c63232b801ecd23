// The golden evaluation vectors on OpenGL.
#include <gtest/gtest.h>

#include "gl_test_context.h"
#include "libbake/gl/gl_renderer.h"
#include "tests/golden/golden_stack.h"

namespace texbake {
namespace {

V3f color_at(const Frame& frame) {
  const glsl::vec4& value = frame.values(0, 0);
  return {value.x, value.y, value.z};
}

TEST(GoldenGl, TheShaderGivesEveryVector) {
  for (const ShaderLanguage language : {ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es}) {
    const auto context = test_context(language);
    if (!context) GTEST_SKIP() << "no OpenGL";
    for (const char* name : kGoldenNames) {
      const Golden golden = read_golden(name);
      GlRenderer renderer(*context, golden.planes);
      for (const GoldenPoint& point : golden.points) {
        const Frame frame = renderer.draw(point.window(Filter::nearest), golden.planes.base);
        EXPECT_EQ(frame.decisions(0, 0), point.decision) << name;
        EXPECT_EQ(color_at(frame), point.nearest) << name;
        EXPECT_EQ(color_at(renderer.draw(point.window(Filter::bilinear), golden.planes.base)), point.bilinear) << name;
        if (point.step_256 == 0) continue;
        const Window trilinear = point.trilinear_window(golden.planes.size);
        EXPECT_EQ(color_at(renderer.draw(trilinear, golden.planes.base)), point.trilinear) << name;
      }
    }
  }
}

TEST(GoldenGl, TheShaderGivesEveryVectorOfAStack) {
  for (const ShaderLanguage language : {ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es}) {
    const auto context = test_context(language);
    if (!context) GTEST_SKIP() << "no OpenGL";
    for (const char* name : kGoldenStackNames) {
      const GoldenStack golden = read_golden_stack(name);
      const int finest = golden.planes.finest();
      GlRenderer renderer(*context, golden.planes);
      std::optional<GlRenderer> with_relief;
      if (golden.relief) with_relief.emplace(*context, golden.planes, &*golden.relief);
      for (const GoldenStackPoint& point : golden.points) {
        const Window nearest = point.near.window(Filter::nearest), bilinear = point.near.window(Filter::bilinear);
        const Frame frame = renderer.draw(nearest, point.view(finest));
        EXPECT_EQ(frame.decisions(0, 0), point.near.decision) << name;
        EXPECT_EQ(color_at(frame), point.near.nearest) << name;
        EXPECT_EQ(color_at(renderer.draw(bilinear, point.view(finest))), point.near.bilinear) << name;
        EXPECT_EQ(color_at(renderer.draw(bilinear, point.faded_view(finest))), point.faded) << name;
        EXPECT_EQ(color_at(renderer.draw(bilinear, point.leveled_view(finest))), point.near.trilinear) << name;
        if (!with_relief) continue;
        const Frame lit = with_relief->draw(bilinear, point.view(finest), point.viewer);
        EXPECT_EQ(lit.decisions(0, 0), point.relief_decision(finest)) << name;
        EXPECT_EQ(color_at(lit), point.lit) << name;
      }
    }
  }
}

}  // namespace
}  // namespace texbake
