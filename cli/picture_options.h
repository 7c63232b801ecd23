// What a picture shows, whatever it shows: the options that render and a camera file share.
#pragma once

#include <optional>
#include <string>

#include "cli/deform_options.h"
#include "cli/relief_options.h"
#include "cli/view_options.h"
#include "libbake/draw/drawing.h"

namespace texbake {

struct PictureOptions {
  std::optional<std::string> map;  ///< nothing: the color
  WindowOptions window;
  ViewOptions view;
  DeformOptions deform;
  ReliefOptions relief;
  SlantOptions slant;
};

/// Everything that can be said without a bundle. Throws Error(usage) for values out of range and for what does not go
/// together.
void check_picture(const PictureOptions& options, PixelSize size);

/// What the options ask for, of a bundle whose finest scale has this size.
DrawRequest draw_request_of(const PictureOptions& options, PixelSize size, V2i tile_size);

}  // namespace texbake
