// The reference shader on OpenGL, as verbs use it; a build without OpenGL has the same functions, which say so.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "libbake/base/options.h"
#include "libbake/draw/drawing.h"
#include "libbake/gl/material_parity.h"

namespace texbake {

/// What draws.
enum class Backend {
  cpu,  ///< the evaluator
  gl,   ///< the reference shader on OpenGL, without a window
};
template <>
struct EnumNames<Backend> {
  static constexpr std::pair<Backend, std::string_view> values[] = {{Backend::cpu, "cpu"}, {Backend::gl, "gl"}};
};

/// Which language of the reference shader.
enum class GlLanguage {
  core,  ///< OpenGL 3.3 core
  es,    ///< OpenGL ES 3.0, that of WebGL 2
  both,
};
template <>
struct EnumNames<GlLanguage> {
  static constexpr std::pair<GlLanguage, std::string_view> values[] = {
      {GlLanguage::core, "core"}, {GlLanguage::es, "es"}, {GlLanguage::both, "both"}};
};

struct GlOptions {
  Backend backend = Backend::cpu;
  std::optional<int> gl_device;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.backend,
          Field{.name = "backend",
                .help = "cpu: the evaluator on the processor; gl: the reference shader on OpenGL, without a window"});
    visit(self.gl_device, Field{.name = "gl-device",
                                .min = 0,
                                .max = 63,
                                .help = "index of the EGL device that draws",
                                .auto_help = "Mesa without a display, otherwise the default display"});
  }
};

/// What one driver gave in one language.
struct LanguageParity {
  GlLanguage language = GlLanguage::core;
  MaterialParity parity;
};

/// Compares the evaluator with the shader in each language. Throws Error(unsupported) where there is no OpenGL, it is
/// too old, or this texbake was built without it.
std::vector<LanguageParity> gl_parity(const DrawnMaterial& material, GlLanguage language,
                                      const std::optional<int>& device, const ParityOptions& options);

/// Draws rows row_begin ≤ j < row_end of a picture.
using DrawRows = std::function<Image<V3f>(int row_begin, int row_end)>;

/// Throws Error(usage) for a picture that `backend` does not draw.
void check_backend(const DrawRequest& request, Backend backend);

/// What draws `drawing`, which must live longer. Throws as gl_parity does.
DrawRows row_drawer(const Drawing& drawing, const GlOptions& options);

}  // namespace texbake
