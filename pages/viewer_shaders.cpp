#include "pages/viewer_shaders.h"

#include <cassert>
#include <utility>

namespace texbake {
namespace {

constexpr std::pair<std::string_view, std::string_view> kTexts[] = {
#include "pages/embedded_shaders.inc"
};

std::string viewer_text(std::string_view name) {
  for (const auto& [candidate, text] : kTexts)
    if (candidate == name) return std::string(text);
  assert(false && "no such shader text");
  return {};
}

}  // namespace

std::string viewer_fragment_shader(ShaderLanguage language) {
  return reference_core(language) + viewer_text("screen.glsl") + viewer_text("viewer.frag");
}

std::string stack_viewer_fragment_shader(ShaderLanguage language) {
  return stack_core(language) + viewer_text("screen.glsl") + viewer_text("stack_viewer.frag");
}

}  // namespace texbake
