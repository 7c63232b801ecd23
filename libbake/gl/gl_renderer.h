// Draws the infinite texture with the reference shader on OpenGL, as an engine would, and reads it back: windows and
// perspective views of one tile, or of a stack of scales.
#pragma once

#include <memory>

#include "libbake/draw/frame.h"
#include "libbake/draw/perspective.h"
#include "libbake/draw/relief_window.h"
#include "libbake/draw/window.h"
#include "libbake/gl/gl_context.h"

namespace texbake {

/// Uploads each texture when it is first drawn; not to be used beyond `context`, planes or relief, and on the context's
/// thread alone. A renderer of a tile draws planes of it, one of a stack the stack. Constructors throw
/// Error(unsupported) when the driver refuses the shader, drawing when it refuses a format or a size.
class GlRenderer {
 public:
  GlRenderer(const GlContext& context, const EvaluatorPlanes& planes);
  /// The same with another fragment shader, which may use what `reference_core` and the .frag texts bind.
  GlRenderer(const GlContext& context, const EvaluatorPlanes& planes, const std::string& fragment_shader);
  /// Of a stack, with the relief of its coarsest scale where that is given.
  GlRenderer(const GlContext& context, const StackPlanes& planes, const ReliefPlanes* relief = nullptr);
  GlRenderer(const GlContext& context, const StackPlanes& planes, const std::string& fragment_shader,
             const ReliefPlanes* relief = nullptr);
  ~GlRenderer();
  GlRenderer(const GlRenderer&) = delete;
  GlRenderer& operator=(const GlRenderer&) = delete;

  /// The window, at most the driver's largest texture on each side. `plane` is the planes' base or one of its maps.
  Frame draw(const Window& window, const Plane& plane);
  /// The same of a perspective view, with a renderer of perspective_fragment_shader: as perspective_frame gives it, or
  /// rows row_begin ≤ j < row_end of that.
  Frame draw(const Perspective& view, const Plane& plane);
  Frame draw(const Perspective& view, const Plane& plane, int row_begin, int row_end);

  /// The window of a stack: what reference_stack_frame gives, or relief_frame.
  Frame draw(const Window& window, const ScaleView& view, const Direction& viewer = {});
  /// Rows of a perspective view, with a renderer of stack_perspective_fragment_shader: as stack_perspective_frame gives
  /// them.
  Frame draw(const Perspective& view, int row_begin, int row_end);

  /// The two halves of `draw`, for measuring: draws into the target and waits until it is drawn; reads the target.
  void draw_only(const Window& window, const Plane& plane);
  void draw_only(const Perspective& view, const Plane& plane, int row_begin, int row_end);
  void draw_only(const Window& window, const ScaleView& view, const Direction& viewer = {});
  void draw_only(const Perspective& view, int row_begin, int row_end);
  Frame read() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbake
