// Sets uniforms of the reference text by their lists (libbake/reference/bindings.h).
#pragma once

#include "libbake/gl/gl_objects.h"
#include "libbake/reference/perspective_program.h"

namespace texbake {

/// Those of `program`, which is current, that it uses.
void set_uniforms(const GlFunctions& gl, const GlProgram& program, const glsl::Program& bound);
void set_uniforms(const GlFunctions& gl, const GlProgram& program, const glsl::PerspectiveProgram& bound);
void set_uniforms(const GlFunctions& gl, const GlProgram& program, const glsl::MainUniforms& main);

}  // namespace texbake
