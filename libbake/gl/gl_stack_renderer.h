// Draws windows of a stack of scales with the reference shader on OpenGL, and reads them back.
#pragma once

#include <memory>

#include "libbake/draw/relief_window.h"
#include "libbake/draw/stack_perspective.h"
#include "libbake/gl/gl_context.h"

namespace texbake {

/// Uploads the planes of a stack once; not to be used beyond `context` or `planes`, and on the context's thread alone.
class GlStackRenderer {
 public:
  /// `relief` is bound where it is given; it must live as long as the planes. Throws Error(unsupported) when the driver
  /// refuses a shader, a format or the size of the planes.
  GlStackRenderer(const GlContext& context, const StackPlanes& planes, const ReliefPlanes* relief = nullptr);
  /// The same with another fragment shader, which may use what `stack_core` and stack.frag bind.
  GlStackRenderer(const GlContext& context, const StackPlanes& planes, const std::string& fragment_shader,
                  const ReliefPlanes* relief = nullptr);
  ~GlStackRenderer();
  GlStackRenderer(const GlStackRenderer&) = delete;
  GlStackRenderer& operator=(const GlStackRenderer&) = delete;

  /// The window, which counts in texels of `view.scale`: what reference_stack_frame gives, or relief_frame.
  Frame draw(const Window& window, const ScaleView& view, const Direction& viewer = {});

  /// Rows row_begin ≤ j < row_end of a perspective view, with a renderer of stack_perspective_fragment_shader: as
  /// stack_perspective_frame gives them.
  Frame draw(const Perspective& view, int row_begin, int row_end);

  /// Draw and wait until it is drawn, for measuring.
  void draw_only(const Window& window, const ScaleView& view, const Direction& viewer = {});
  void draw_only(const Perspective& view, int row_begin, int row_end);

 private:
  Frame read() const;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbake
