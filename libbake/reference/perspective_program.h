// The text of the perspective view as a C++ type, on top of Program.
#pragma once

#include "libbake/reference/program.h"

namespace texbake::glsl {

struct PerspectiveProgram : Program {
  vec3 view_corner{0, 0, 1};
  vec3 view_right{0, 0, 0};
  vec3 view_down{0, 0, 0};
  float view_height = 1;
  int view_filter = 1;

#define PRECISE
#include "shaders/perspective.glsl"
//
#include "shaders/stack_perspective.glsl"
#undef PRECISE
};

using Sight = PerspectiveProgram::Sight;

}  // namespace texbake::glsl
