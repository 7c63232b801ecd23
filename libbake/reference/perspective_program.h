// The text of the perspective view as a C++ type, on top of Program.
#pragma once

#include "libbake/reference/program.h"

namespace texbake::glsl {

struct PerspectiveProgram : Program, CameraUniforms {
#define PRECISE
#include "shaders/perspective.glsl"
//
#include "shaders/stack_perspective.glsl"
#undef PRECISE
};

using Sight = PerspectiveProgram::Sight;

}  // namespace texbake::glsl
