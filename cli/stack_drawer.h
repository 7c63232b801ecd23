// Draws all scales of a bundle together, and the relief of the coarsest.
#pragma once

#include "cli/gl_backend.h"
#include "cli/relief_options.h"
#include "cli/view_options.h"
#include "formats/bundle.h"

namespace texbake {

/// A picture of a stack: what render's options say of it.
struct StackPicture {
  PixelSize size{1, 1};
  WindowOptions window;
  ViewOptions view;
  ReliefOptions relief;
  SlantOptions slant;
  GlOptions gl;
};

inline bool has_relief(const ReliefOptions& options) { return options.depth_px > 0; }

/// The relief of a stack's coarsest scale; nullptr where the options ask for none. Throws as relief_planes does.
std::shared_ptr<const ReliefPlanes> relief_of(const Scale& coarsest, const ReliefOptions& options,
                                              const SlantOptions& slant);

/// Draws rows of the picture. Borrows `bundle`. Throws Error(usage) for what the bundle does not have.
DrawRows stack_drawer(const Bundle& bundle, const StackPicture& picture);

}  // namespace texbake
