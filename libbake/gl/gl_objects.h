// Owners of OpenGL objects: a linked program, textures, and a target to draw into.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libbake/gl/gl_functions.h"
#include "libbake/reference/glsl.h"

namespace texbake {

/// A vertex and a fragment shader, linked.
class GlProgram {
 public:
  /// Throws Error(unsupported) with the driver's log.
  GlProgram(const GlFunctions& gl, const std::string& vertex_text, const std::string& fragment_text);
  ~GlProgram() { gl_.DeleteProgram(name_); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  GLuint name() const { return name_; }
  /// −1 where the program does not use the uniform, which every glUniform call then ignores.
  GLint uniform(const char* name) const { return gl_.GetUniformLocation(name_, name); }

 private:
  const GlFunctions& gl_;
  GLuint name_;
};

/// How texels are stored on the GPU and given to it.
struct GlFormat {
  GLint internal_format;
  GLenum format;
  GLenum type;
};
/// Of the texels of a texture, by their type.
template <class Texel>
inline constexpr GlFormat kGlFormat{};
template <>
inline constexpr GlFormat kGlFormat<glsl::PatchTexel>{GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT};
template <>
inline constexpr GlFormat kGlFormat<glsl::MaskTexel>{GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT};
template <>
inline constexpr GlFormat kGlFormat<glsl::LevelBlock>{GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT};
template <>
inline constexpr GlFormat kGlFormat<glsl::FragmentTexel>{GL_RGBA16I, GL_RGBA_INTEGER, GL_SHORT};
template <>
inline constexpr GlFormat kGlFormat<glsl::ivec4>{GL_RGBA32I, GL_RGBA_INTEGER, GL_INT};
template <>
inline constexpr GlFormat kGlFormat<glsl::uvec4>{GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
template <>
inline constexpr GlFormat kGlFormat<glsl::vec4>{GL_RGBA32F, GL_RGBA, GL_FLOAT};

/// A texture of one level, not filtered: texels are fetched by number.
class GlTexture {
 public:
  GlTexture(const GlFunctions& gl, const GlFormat& format, int width, int height, const void* texels);
  ~GlTexture() { gl_.DeleteTextures(1, &name_); }  // 0 is ignored
  GlTexture(GlTexture&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  void bind(int unit) const;
  GLuint name() const { return name_; }

 private:
  const GlFunctions& gl_;
  GLuint name_ = 0;
};

/// Values in RGBA32F and decisions in RGBA32UI, drawn together.
class GlTarget {
 public:
  /// Throws Error(unsupported) when the driver cannot draw into them.
  GlTarget(const GlFunctions& gl, int width, int height);
  ~GlTarget() { gl_.DeleteFramebuffers(1, &framebuffer_); }
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  void bind() const;
  /// Four 32-bit values to a pixel, lowest line first.
  void read_values(void* pixels) const { read(GL_COLOR_ATTACHMENT0, kGlFormat<glsl::vec4>, pixels); }
  void read_decisions(void* pixels) const { read(GL_COLOR_ATTACHMENT1, kGlFormat<glsl::uvec4>, pixels); }

 private:
  void read(GLenum attachment, const GlFormat& format, void* pixels) const;

  const GlFunctions& gl_;
  int width_, height_;
  GlTexture values_, decisions_;
  GLuint framebuffer_ = 0;
};

}  // namespace texbake
