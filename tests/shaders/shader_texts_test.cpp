#include "shaders/shader_texts.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

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

/// The words that follow `before` and a type in `text`.
std::vector<std::string> names_after(std::string_view text, const char* pattern) {
  const std::string whole(text);
  const std::regex expression(pattern);
  std::vector<std::string> names;
  for (std::sregex_iterator at(whole.begin(), whole.end(), expression), end; at != end; ++at) names.push_back((*at)[1]);
  return names;
}

// Engines declare uniforms by macros, and refuse a parameter that carries the name of one.
TEST(ShaderTexts, NoParameterOfAFunctionHasTheNameOfAUniform) {
  std::set<std::string> uniforms;
  for (const char* name : {"bindings.glsl", "stack_bindings.glsl", "relief_bindings.glsl", "perspective_bindings.glsl",
                           "reference.frag", "perspective.frag", "stack.frag", "stack_perspective.frag"})
    for (const std::string& uniform : names_after(shader_text(name), R"(uniform \w+ (\w+))")) uniforms.insert(uniform);
  EXPECT_TRUE(uniforms.contains("step_256"));
  for (const char* name : {"hash.glsl", "content.glsl", "sample.glsl", "noise.glsl", "levels.glsl", "deform.glsl",
                           "perspective.glsl", "scales.glsl", "stack_levels.glsl", "relief.glsl", "stack_relief.glsl",
                           "stack_probes.glsl", "stack_perspective.glsl"}) {
    const std::vector<std::string> parameters = names_after(shader_text(name), R"([(,]\s*\w+ (\w+)(?=[,)]))");
    EXPECT_FALSE(parameters.empty()) << name;
    for (const std::string& parameter : parameters)
      EXPECT_FALSE(uniforms.contains(parameter)) << parameter << " in " << name;
  }
}

TEST(ShaderTexts, SamplersOfES300AreHighp) {
  const std::string text = reference_core(ShaderLanguage::glsl_300_es);
  for (const char* type : {"sampler2D", "isampler2D", "usampler2D"})
    EXPECT_NE(text.find("precision highp " + std::string(type)), std::string::npos);
}

}  // namespace
}  // namespace texbake
