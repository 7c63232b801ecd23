#include "libbake/gl/gl_uniforms.h"

namespace texbake {
namespace {

// Arrays are given to OpenGL as they lie in memory.
static_assert(sizeof(glsl::uvec4) == 16 && sizeof(glsl::ivec2) == 8);

/// What the lists call: sets one uniform. A program that lacks it ignores that.
struct UniformSetter {
  const GlFunctions& gl;
  const GlProgram& program;

  template <class T>
  void operator()(const char* name, const T& value) const {
    set(program.uniform(name), value);
  }

  void set(GLint at, int v) const { gl.Uniform1i(at, v); }
  void set(GLint at, glsl::uint v) const { gl.Uniform1ui(at, v); }
  void set(GLint at, float v) const { gl.Uniform1f(at, v); }
  void set(GLint at, const glsl::ivec2& v) const { gl.Uniform2i(at, v.x, v.y); }
  void set(GLint at, const glsl::uvec2& v) const { gl.Uniform2ui(at, v.x, v.y); }
  void set(GLint at, const glsl::ivec4& v) const { gl.Uniform4i(at, v.x, v.y, v.z, v.w); }
  void set(GLint at, const glsl::vec3& v) const { gl.Uniform3f(at, v.x, v.y, v.z); }
  void set(GLint at, const glsl::vec4& v) const { gl.Uniform4f(at, v.x, v.y, v.z, v.w); }
  template <size_t N>
  void set(GLint at, const glsl::uvec4 (&v)[N]) const {
    gl.Uniform4uiv(at, N, &v[0].x);
  }
  template <size_t N>
  void set(GLint at, const glsl::ivec2 (&v)[N]) const {
    gl.Uniform2iv(at, N, &v[0].x);
  }
};

}  // namespace

void set_uniforms(const GlFunctions& gl, const GlProgram& program, const glsl::Program& bound) {
  glsl::for_each_uniform(bound, UniformSetter{gl, program});
}

void set_uniforms(const GlFunctions& gl, const GlProgram& program, const glsl::PerspectiveProgram& bound) {
  glsl::for_each_uniform(bound, UniformSetter{gl, program});
}

void set_uniforms(const GlFunctions& gl, const GlProgram& program, const glsl::MainUniforms& main) {
  glsl::MainUniforms::fields(main, UniformSetter{gl, program});
}

}  // namespace texbake
