#include "shaders/shader_texts.h"

#include <cassert>
#include <initializer_list>
#include <utility>

namespace texbake {
namespace {

constexpr std::pair<std::string_view, std::string_view> kTexts[] = {
#include "shaders/embedded_texts.inc"
};

std::string concatenated(std::initializer_list<std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += shader_text(name);
  return text;
}

std::string_view prologue(ShaderLanguage language) {
  return language == ShaderLanguage::glsl_330 ? "prologue_330.glsl" : "prologue_300es.glsl";
}

}  // namespace

std::string_view shader_text(std::string_view name) {
  for (const auto& [candidate, text] : kTexts)
    if (candidate == name) return text;
  assert(false && "no such shader text");
  return {};
}

std::string reference_core(ShaderLanguage language) {
  return concatenated({prologue(language), "constants.glsl", "bindings.glsl", "hash.glsl", "content.glsl",
                       "sample.glsl", "noise.glsl", "levels.glsl", "deform.glsl"});
}

std::string stack_core(ShaderLanguage language) {
  return concatenated({prologue(language), "constants.glsl", "stack_bindings.glsl", "hash.glsl", "content.glsl",
                       "sample.glsl", "noise.glsl", "levels.glsl", "scales.glsl", "stack_levels.glsl",
                       "relief_bindings.glsl", "relief.glsl", "stack_relief.glsl", "stack_probes.glsl"});
}

std::string stack_fragment_shader(ShaderLanguage language) {
  return stack_core(language) + concatenated({"stack.frag"});
}

std::string stack_perspective_fragment_shader(ShaderLanguage language) {
  return stack_core(language) + concatenated({"perspective_bindings.glsl", "perspective.glsl", "stack_perspective.glsl",
                                              "stack_perspective.frag"});
}

std::string reference_vertex_shader(ShaderLanguage language) {
  return concatenated({prologue(language), "reference.vert"});
}

std::string reference_fragment_shader(ShaderLanguage language) {
  return reference_core(language) + concatenated({"reference.frag"});
}

std::string perspective_fragment_shader(ShaderLanguage language) {
  return reference_core(language) + concatenated({"perspective_bindings.glsl", "perspective.glsl", "perspective.frag"});
}

}  // namespace texbake
