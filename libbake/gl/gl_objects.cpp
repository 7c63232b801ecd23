#include "libbake/gl/gl_objects.h"

#include <fmt/format.h>

#include "libbake/base/error.h"

namespace texbake {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& log) {
  throw Error(ErrorKind::unsupported, fmt::format("OpenGL: the driver rejects {}: {}", what, log));
}

GLuint compiled(const GlFunctions& gl, GLenum stage, const std::string& text) {
  const GLuint shader = gl.CreateShader(stage);
  const char* const source = text.c_str();
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint done = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  gl.DeleteShader(shader);
  refuse(stage == GL_VERTEX_SHADER ? "the vertex shader" : "the fragment shader",
         log.substr(0, static_cast<size_t>(length)));
}

}  // namespace

GlProgram::GlProgram(const GlFunctions& gl, const std::string& vertex_text, const std::string& fragment_text)
    : gl_(gl), name_(gl.CreateProgram()) {
  for (const auto& [stage, text] : {std::pair(GL_VERTEX_SHADER, &vertex_text), {GL_FRAGMENT_SHADER, &fragment_text}}) {
    const GLuint shader = compiled(gl, static_cast<GLenum>(stage), *text);
    gl.AttachShader(name_, shader);
    gl.DeleteShader(shader);
  }
  gl.LinkProgram(name_);
  GLint done = 0;
  gl.GetProgramiv(name_, GL_LINK_STATUS, &done);
  if (done) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetProgramInfoLog(name_, static_cast<GLsizei>(log.size()), &length, log.data());
  gl.DeleteProgram(name_);
  refuse("the program", log.substr(0, static_cast<size_t>(length)));
}

GlTexture::GlTexture(const GlFunctions& gl, const GlFormat& format, int width, int height, const void* texels)
    : gl_(gl) {
  GLint largest = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (width > largest || height > largest)
    refuse(fmt::format("a texture of {} x {} texels", width, height), fmt::format("at most {} on each side", largest));
  gl.GenTextures(1, &name_);
  gl.BindTexture(GL_TEXTURE_2D, name_);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, format.internal_format, width, height, 0, format.format, format.type, texels);
  if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) {
    gl.DeleteTextures(1, &name_);
    refuse(fmt::format("a texture of {} x {} texels", width, height), fmt::format("error {:#x}", error));
  }
}

void GlTexture::bind(int unit) const {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, name_);
}

GlTarget::GlTarget(const GlFunctions& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      values_(gl, kGlFormat<glsl::vec4>, width, height, nullptr),
      decisions_(gl, kGlFormat<glsl::uvec4>, width, height, nullptr) {
  gl.GenFramebuffers(1, &framebuffer_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, values_.name(), 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, decisions_.name(), 0);
  const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  gl.DrawBuffers(2, attachments);
  if (const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER); status != GL_FRAMEBUFFER_COMPLETE) {
    gl.DeleteFramebuffers(1, &framebuffer_);
    refuse("a target of RGBA32F and RGBA32UI", fmt::format("status {:#x}", status));
  }
}

void GlTarget::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, width_, height_);
}

void GlTarget::read(GLenum attachment, const GlFormat& format, void* pixels) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.ReadBuffer(attachment);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width_, height_, format.format, format.type, pixels);
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR)
    refuse("reading a target", fmt::format("error {:#x}", error));
}

}  // namespace texbake
