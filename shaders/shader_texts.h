// The shader texts, embedded at build time, and how they are put together for each language.
#pragma once

#include <string>
#include <string_view>

namespace texbake {

enum class ShaderLanguage {
  glsl_330,     ///< OpenGL 3.3 core
  glsl_300_es,  ///< OpenGL ES 3.0, WebGL 2
};

/// The text of shaders/`name`, such as "hash.glsl"; `name` is one of the files there.
std::string_view shader_text(std::string_view name);

/// Complete texts: prologue, then bindings and core where needed, then reference.vert or reference.frag.
std::string reference_vertex_shader(ShaderLanguage language);
std::string reference_fragment_shader(ShaderLanguage language);

/// An endless plane in perspective, drawn with reference_vertex_shader.
std::string perspective_fragment_shader(ShaderLanguage language);

/// The text of several scales, with stack.frag, drawn with reference_vertex_shader.
std::string stack_fragment_shader(ShaderLanguage language);

/// The same as an endless plane in perspective.
std::string stack_perspective_fragment_shader(ShaderLanguage language);

/// Prologue, bindings and core, for another fragment shader's `main` to follow: of one scale; of several.
std::string reference_core(ShaderLanguage language);
std::string stack_core(ShaderLanguage language);

}  // namespace texbake
