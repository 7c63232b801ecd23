// The reference shader on OpenGL, as verbs use it; a build without OpenGL has the same functions, which say so.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "libbake/base/options.h"
#include "libbake/gl/parity.h"
#include "libbake/gl/perspective_parity.h"
#include "libbake/planes/relief_planes.h"
#include "libbake/planes/stack_planes.h"

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
    visit(self.backend, Field{.name = "backend", .help = "gl: the reference shader on OpenGL, without a window"});
    visit(self.gl_device, Field{.name = "gl-device",
                                .min = 0,
                                .max = 63,
                                .help = "number of the EGL device that draws",
                                .auto_help = "Mesa without a display, else the default display"});
  }
};

/// What one driver gave in one language.
struct LanguageParity {
  GlLanguage language = GlLanguage::core;
  ParityReport report;
  PerspectiveParity perspective = {};
  PerspectiveParity relief = {};  ///< windows with relief; nothing where there is none

  bool equal() const { return report.equal() && perspective.equal() && relief.equal(); }
};

/// A tile with heights, as a stack of one scale, whose levels were added.
struct TileRelief {
  const StackPlanes& stack;
  const ReliefPlanes& relief;
};

/// Compares the evaluator with the shader in each language, with relief too where it is given. Throws
/// Error(unsupported) where there is no OpenGL, it is too old, or this texbake was built without it. The levels of
/// `planes` were added.
std::vector<LanguageParity> gl_parity(const EvaluatorPlanes& planes, const std::optional<TileRelief>& relief,
                                      GlLanguage language, const std::optional<int>& device,
                                      const ParityOptions& options);

/// The same for all scales of a stack together; with the relief of the coarsest, where it is given.
std::vector<LanguageParity> gl_stack_parity(const StackPlanes& planes, const ReliefPlanes* relief, GlLanguage language,
                                            const std::optional<int>& device, const ParityOptions& options);

/// Draws rows row_begin ≤ j < row_end of a window.
using DrawRows = std::function<Image<V3f>(int row_begin, int row_end)>;

/// Draws `plane`, whose levels were added where the view needs them, in OpenGL 3.3 core; borrows `planes`. Throws as
/// gl_parity does.
DrawRows gl_row_drawer(const EvaluatorPlanes& planes, const Plane& plane, const Window& window,
                       const std::optional<int>& device);
DrawRows gl_row_drawer(const EvaluatorPlanes& planes, const Plane& plane, const Perspective& view,
                       const std::optional<int>& device);

/// The same of all scales of a stack, with the relief of the coarsest where it is given, seen from `viewer` in a
/// window; `keeper` lives as long as what is returned.
DrawRows gl_stack_row_drawer(const StackPlanes& planes, const ReliefPlanes* relief, const Direction& viewer,
                             const Window& window, const std::optional<int>& device,
                             std::shared_ptr<const void> keeper);
DrawRows gl_stack_row_drawer(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view,
                             const std::optional<int>& device, std::shared_ptr<const void> keeper);

}  // namespace texbake
