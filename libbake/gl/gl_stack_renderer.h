// Draws windows of a stack of scales with the reference shader on OpenGL, and reads them back.
#pragma once

#include <memory>

#include "libbake/eval/stack_window.h"
#include "libbake/gl/gl_context.h"

namespace texbake {

/// Uploads the planes of a stack once; not to be used beyond `context` or `planes`, and on the context's thread alone.
class GlStackRenderer {
 public:
  /// Throws Error(unsupported) when the driver refuses a shader, a format or the size of the planes.
  GlStackRenderer(const GlContext& context, const StackPlanes& planes);
  ~GlStackRenderer();
  GlStackRenderer(const GlStackRenderer&) = delete;
  GlStackRenderer& operator=(const GlStackRenderer&) = delete;

  /// The window, which counts in texels of `view.scale`: what reference_stack_frame gives.
  Frame draw(const Window& window, const ScaleView& view);
  /// Draws and waits until it is drawn, for measuring.
  void draw_only(const Window& window, const ScaleView& view);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbake
