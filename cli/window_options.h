// Which window of the infinite texture is meant: the options that render and a camera file share.
#pragma once

#include <optional>
#include <string>

#include "libbake/base/option_text.h"
#include "libbake/draw/window.h"

namespace texbake {

struct WindowOptions {
  std::string origin = "0,0";
  double step_texels = 1;
  uint32_t seed = 0;
  Filter filter = Filter::trilinear;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.origin,
          Field{.name = "origin",
                .unit = "X,Y",
                .help = "upper left corner of the window in texels; may be negative, very far away, or fractional"});
    visit(self.step_texels, Field{.name = "step",
                                  .unit = "texels",
                                  .min = 0.00390625,
                                  .max = 65536,
                                  .help = "distance from one pixel to the next, in steps of 1/256 texel"});
    visit(self.seed, Field{.name = "seed",
                           .min = 0,
                           .max = 4294967295.0,
                           .help = "seed of the texture; another seed gives another texture from the same bundle"});
    visit(self.filter, Field{.name = "filter",
                             .help = "how a pixel is interpolated; trilinear and anisotropic use mip levels, so that "
                                     "no texel is skipped when pixels are larger than texels"});
  }
};

/// Throws Error(usage) when the options do not name a window of the infinite texture.
Window window_of(const WindowOptions& options, PixelSize size, V2i tile_size);

}  // namespace texbake
