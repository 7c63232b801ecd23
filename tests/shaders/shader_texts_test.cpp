#include "shaders/shader_texts.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(ShaderTexts, EachLanguageBeginsWithItsVersion) {
  EXPECT_TRUE(reference_fragment_shader(ShaderLanguage::glsl_330).starts_with("#version 330 core\n"));
  EXPECT_TRUE(reference_vertex_shader(ShaderLanguage::glsl_300_es).starts_with("#version 300 es\n"));
}

TEST(ShaderTexts, TheCoreIsTheSameTextInEachLanguage) {
  const std::string core(shader_text("hash.glsl"));
  for (const ShaderLanguage language : {ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es}) {
    EXPECT_NE(reference_core(language).find(core), std::string::npos);
    EXPECT_NE(reference_core(language).find(shader_text("sample.glsl")), std::string::npos);
  }
}

TEST(ShaderTexts, TheExactPathUsesNoBannedWord) {
  for (const char* name : {"hash.glsl", "content.glsl", "sample.glsl", "levels.glsl"})
    for (const char* word : {"fma(", "mix(", "dot(", "normalize(", "smoothstep(", "pow(", "exp(", "sin(", "cos(",
                             "texture(", "textureLod(", "textureGrad(", "inversesqrt("})
      EXPECT_EQ(shader_text(name).find(word), std::string_view::npos) << word << " in " << name;
}

}  // namespace
}  // namespace texbake
