#include "cli/window_options.h"

#include <cmath>

namespace texbake {
namespace {

constexpr double kStepsPerTexel = 256;  // of Window::step_256

}  // namespace

Window window_of(const WindowOptions& options, PixelSize size, V2i tile_size) {
  const DecimalPoint origin = parse_point("origin", options.origin);
  Window window;
  window.origin_x = tile_offset(origin.x, tile_size.x, "origin");
  window.origin_y = tile_offset(origin.y, tile_size.y, "origin");
  window.step_256 = static_cast<uint32_t>(std::lround(options.step_texels * kStepsPerTexel));
  window.width = size.width;
  window.height = size.height;
  window.seed = options.seed;
  window.filter = options.filter;
  check_window(window, tile_size);
  return window;
}

}  // namespace texbake
