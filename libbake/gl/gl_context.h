// An OpenGL context without a window or a display, by EGL loaded at run time.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "shaders/shader_texts.h"

namespace texbake {

struct GlFunctions;

struct GlContextOptions {
  ShaderLanguage language = ShaderLanguage::glsl_330;  ///< GL 3.3 core, or GL ES 3.0
  std::optional<int> device;  ///< number of an EGL device; without one, Mesa's surfaceless platform, then any display
};

/// Current on the thread that made it, which alone may use it, until it is destroyed. One at a time on a thread.
class GlContext {
 public:
  /// Throws Error(unsupported) where EGL, a display, the language's version or float targets are missing.
  explicit GlContext(const GlContextOptions& options = {});
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  ShaderLanguage language() const;
  const GlFunctions& functions() const;
  /// What the driver calls itself: "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
  std::string description() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbake
