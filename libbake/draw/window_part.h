// A part of a window as a window of its own, so that a window of any size can be drawn in tiles.
#pragma once

#include "libbake/draw/window.h"

namespace texbake {

/// Pixels `first` ≤ (i, j) < `first` + `size` of `window`: they show the same points, to 1/256 texel.
Window part_of(const Window& window, V2i tile_size, V2i first, V2i size);

/// The point that pixel (i, j) of `window` shows.
struct WindowPoint {
  TileOffset x, y;
};
WindowPoint point_of(const Window& window, V2i tile_size, V2i pixel);

}  // namespace texbake
