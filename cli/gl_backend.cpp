#include "cli/gl_backend.h"

#include <memory>

#include "libbake/gl/gl_drawing.h"

namespace texbake {

#ifdef TEXBAKE_WITH_GL

void check_backend(const DrawRequest& request, Backend backend) {
  if (backend == Backend::gl) check_gl_request(request);
}

std::vector<LanguageParity> gl_parity(const DrawnMaterial& material, GlLanguage language,
                                      const std::optional<int>& device, const ParityOptions& options) {
  const ParityMaterial prepared(material);
  std::vector<LanguageParity> found;
  for (const GlLanguage one : {GlLanguage::core, GlLanguage::es}) {
    if (language != one && language != GlLanguage::both) continue;
    const GlContext context({one == GlLanguage::es ? ShaderLanguage::glsl_300_es : ShaderLanguage::glsl_330, device});
    found.push_back({one, prepared.check(context, options)});
  }
  return found;
}

DrawRows row_drawer(const Drawing& drawing, const GlOptions& options) {
  if (options.backend == Backend::cpu) return [&](int begin, int end) { return drawing.rows(begin, end); };
  const auto drawn = std::make_shared<GlDrawing>(drawing, options.gl_device);
  return [drawn](int begin, int end) { return drawn->rows(begin, end); };
}

#else
namespace {

[[noreturn]] void refuse() {
  throw Error(ErrorKind::unsupported,
              "--backend gl: this texbake was built without OpenGL; build it where EGL/eglext.h and GL/glcorearb.h are "
              "installed (Debian: libegl-dev libgl-dev)");
}

}  // namespace

void check_backend(const DrawRequest&, Backend backend) {
  if (backend == Backend::gl) refuse();
}

std::vector<LanguageParity> gl_parity(const DrawnMaterial&, GlLanguage, const std::optional<int>&,
                                      const ParityOptions&) {
  refuse();
}

DrawRows row_drawer(const Drawing& drawing, const GlOptions& options) {
  check_backend(drawing.request(), options.backend);
  return [&](int begin, int end) { return drawing.rows(begin, end); };
}
#endif

}  // namespace texbake
