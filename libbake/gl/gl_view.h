// Binds what perspective.glsl reads of a view.
#pragma once

#include "libbake/draw/perspective.h"
#include "libbake/gl/gl_objects.h"

namespace texbake {

/// Uniforms of `program`, which is current; `sky` is the colour where the plane is not seen.
void set_perspective(const GlFunctions& gl, const GlProgram& program, const Perspective& view, const V3f& sky);

}  // namespace texbake
