// Draws a prepared picture with the reference shader on OpenGL, by rows, as the processor draws it.
#pragma once

#include <memory>
#include <optional>

#include "libbake/draw/drawing.h"

namespace texbake {

class GlDrawing {
 public:
  /// Uploads `drawing`, which must live longer. `device` is the number of an EGL device; nothing: GlContextOptions'.
  /// Throws Error(unsupported) where there is no OpenGL, or it is too old or too small; Error(usage) for views of how
  /// the texture is put together and for several samples to a pixel, which the reference shader does not draw.
  GlDrawing(const Drawing& drawing, const std::optional<int>& device);
  ~GlDrawing();

  /// As Drawing::rows.
  Image<V3f> rows(int row_begin, int row_end);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The part of it that needs no OpenGL. Throws Error(usage).
void check_gl_request(const DrawRequest& request);

}  // namespace texbake
