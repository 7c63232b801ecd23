#include "cli/gl_backend.h"

#include <memory>

#ifdef TEXBAKE_WITH_GL
#include "libbake/gl/gl_rows.h"
#include "libbake/gl/stack_parity.h"
#endif

namespace texbake {

#ifdef TEXBAKE_WITH_GL
namespace {

GlContextOptions context_options(GlLanguage language, const std::optional<int>& device) {
  return {language == GlLanguage::es ? ShaderLanguage::glsl_300_es : ShaderLanguage::glsl_330, device};
}

/// A renderer is destroyed before the context that it draws on.
struct Drawer {
  GlContext context;
  GlRenderer renderer;
  Drawer(const EvaluatorPlanes& planes, const std::optional<int>& device, const std::string& fragment_shader)
      : context(context_options(GlLanguage::core, device)), renderer(context, planes, fragment_shader) {}
};

struct StackDrawer {
  GlContext context;
  GlRenderer renderer;
  StackDrawer(const StackPlanes& planes, const std::optional<int>& device, const std::string& fragment_shader,
              const ReliefPlanes* relief)
      : context(context_options(GlLanguage::core, device)), renderer(context, planes, fragment_shader, relief) {}
};

template <class Check>
std::vector<LanguageParity> in_languages(GlLanguage language, const std::optional<int>& device, const Check& check) {
  std::vector<LanguageParity> found;
  for (const GlLanguage one : {GlLanguage::core, GlLanguage::es}) {
    if (language != one && language != GlLanguage::both) continue;
    const GlContext context(context_options(one, device));
    found.push_back(check(one, context));
  }
  return found;
}

}  // namespace

std::vector<LanguageParity> gl_parity(const EvaluatorPlanes& planes, const std::optional<TileRelief>& relief,
                                      GlLanguage language, const std::optional<int>& device,
                                      const ParityOptions& options) {
  return in_languages(language, device, [&](GlLanguage one, const GlContext& context) -> LanguageParity {
    LanguageParity parity{one, check_parity(planes, context, options), check_perspective_parity(planes, context)};
    if (!relief) return parity;
    parity.perspective += check_stack_perspective_parity(relief->stack, &relief->relief, context);
    parity.relief = check_relief_parity(relief->stack, relief->relief, context);
    return parity;
  });
}

std::vector<LanguageParity> gl_stack_parity(const StackPlanes& planes, const ReliefPlanes* relief, GlLanguage language,
                                            const std::optional<int>& device, const ParityOptions& options) {
  return in_languages(language, device, [&](GlLanguage one, const GlContext& context) -> LanguageParity {
    LanguageParity parity{one, check_stack_parity(planes, context, options),
                          check_stack_perspective_parity(planes, relief, context)};
    if (relief) parity.relief = check_relief_parity(planes, *relief, context);
    return parity;
  });
}

DrawRows gl_row_drawer(const EvaluatorPlanes& planes, const Plane& plane, const Window& window,
                       const std::optional<int>& device) {
  const auto drawer = std::make_shared<Drawer>(planes, device, reference_fragment_shader(ShaderLanguage::glsl_330));
  return [drawer, &planes, &plane, window](int begin, int end) {
    return gl_rows(drawer->renderer, planes, plane, window, begin, end);
  };
}

DrawRows gl_row_drawer(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view,
                       const std::optional<int>& device) {
  const auto drawer = std::make_shared<Drawer>(planes, device, perspective_fragment_shader(ShaderLanguage::glsl_330));
  return [drawer, &plane, view](int begin, int end) {
    return color_values(drawer->renderer.draw(view, plane, begin, end).values);
  };
}

DrawRows gl_stack_row_drawer(const StackPlanes& planes, const ReliefPlanes* relief, const Direction& viewer,
                             const Window& window, const std::optional<int>& device,
                             std::shared_ptr<const void> keeper) {
  const auto drawer =
      std::make_shared<StackDrawer>(planes, device, stack_fragment_shader(ShaderLanguage::glsl_330), relief);
  return [drawer, &planes, viewer, window, keeper](int begin, int end) {
    return gl_rows(drawer->renderer, planes, viewer, window, begin, end);
  };
}

DrawRows gl_stack_row_drawer(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view,
                             const std::optional<int>& device, std::shared_ptr<const void> keeper) {
  const auto drawer = std::make_shared<StackDrawer>(
      planes, device, stack_perspective_fragment_shader(ShaderLanguage::glsl_330), relief);
  return [drawer, view, keeper](int begin, int end) {
    return color_values(drawer->renderer.draw(view, begin, end).values);
  };
}

#else
namespace {

[[noreturn]] void refuse() {
  throw Error(ErrorKind::unsupported,
              "--backend gl: this texbake was built without OpenGL; build it where EGL/eglext.h and GL/glcorearb.h are "
              "(Debian: libegl-dev libgl-dev)");
}

}  // namespace

std::vector<LanguageParity> gl_parity(const EvaluatorPlanes&, const std::optional<TileRelief>&, GlLanguage,
                                      const std::optional<int>&, const ParityOptions&) {
  refuse();
}

std::vector<LanguageParity> gl_stack_parity(const StackPlanes&, const ReliefPlanes*, GlLanguage,
                                            const std::optional<int>&, const ParityOptions&) {
  refuse();
}

DrawRows gl_row_drawer(const EvaluatorPlanes&, const Plane&, const Window&, const std::optional<int>&) { refuse(); }
DrawRows gl_row_drawer(const EvaluatorPlanes&, const Plane&, const Perspective&, const std::optional<int>&) {
  refuse();
}
DrawRows gl_stack_row_drawer(const StackPlanes&, const ReliefPlanes*, const Direction&, const Window&,
                             const std::optional<int>&, std::shared_ptr<const void>) {
  refuse();
}
DrawRows gl_stack_row_drawer(const StackPlanes&, const ReliefPlanes*, const Perspective&, const std::optional<int>&,
                             std::shared_ptr<const void>) {
  refuse();
}
#endif

}  // namespace texbake
