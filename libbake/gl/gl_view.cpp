#include "libbake/gl/gl_view.h"

#include "libbake/draw/view_program.h"

namespace texbake {

void set_perspective(const GlFunctions& gl, const GlProgram& program, const Perspective& view, const V3f& sky) {
  const PerspectiveRays rays = rays_of(view);
  const auto set = [&](const char* name, const glsl::vec3& v) { gl.Uniform3f(program.uniform(name), v.x, v.y, v.z); };
  set("view_corner", rays.corner);
  set("view_right", rays.right);
  set("view_down", rays.down);
  gl.Uniform1f(program.uniform("view_height"), rays.height);
  gl.Uniform1i(program.uniform("view_filter"), view_filter(view.filter));
  gl.Uniform4f(program.uniform("sky"), sky.x, sky.y, sky.z, 0);
}

}  // namespace texbake
