// Draws windows of the infinite texture with the reference shader on OpenGL, as an engine would, and reads them back.
#pragma once

#include <memory>

#include "libbake/draw/frame.h"
#include "libbake/draw/perspective.h"
#include "libbake/draw/window.h"
#include "libbake/gl/gl_context.h"

namespace texbake {

/// Uploads prepared planes once; not to be used beyond `context` or `planes`, and on the context's thread alone.
class GlRenderer {
 public:
  /// Throws Error(unsupported) when the driver refuses a shader, a format or the size of the tile.
  GlRenderer(const GlContext& context, const EvaluatorPlanes& planes);
  /// The same with another fragment shader, which may use what `reference_core` and reference.frag bind.
  GlRenderer(const GlContext& context, const EvaluatorPlanes& planes, const std::string& fragment_shader);
  ~GlRenderer();
  GlRenderer(const GlRenderer&) = delete;
  GlRenderer& operator=(const GlRenderer&) = delete;

  /// The window, at most the driver's largest texture on each side. `plane` is the planes' base or one of its maps.
  Frame draw(const Window& window, const Plane& plane);

  /// The same of a perspective view, with a renderer of perspective_fragment_shader: as perspective_frame gives it, or
  /// rows row_begin ≤ j < row_end of that.
  Frame draw(const Perspective& view, const Plane& plane);
  Frame draw(const Perspective& view, const Plane& plane, int row_begin, int row_end);

  /// The two halves of `draw`, for measuring: draws into the target and waits until it is drawn; reads the target.
  void draw_only(const Window& window, const Plane& plane);
  void draw_only(const Perspective& view, const Plane& plane, int row_begin, int row_end);
  Frame read() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbake
