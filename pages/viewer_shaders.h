// The shaders of the viewer: the reference text with a viewer's main.
#pragma once

#include <string>

#include "shaders/shader_texts.h"

namespace texbake {

/// reference_core with viewer.frag, stack_core with stack_viewer.frag; drawn with reference_vertex_shader.
std::string viewer_fragment_shader(ShaderLanguage language);
std::string stack_viewer_fragment_shader(ShaderLanguage language);

}  // namespace texbake
