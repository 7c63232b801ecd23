#include "libbake/draw/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libbake/base/error.h"
#include "libbake/base/portable_math.h"

namespace texbake {

void check_window(const Window& window, V2i tile_size) {
  if (window.width < 1 || window.height < 1)
    throw Error(ErrorKind::usage,
                fmt::format("window: expected at least 1 x 1 pixels, found {} x {}", window.width, window.height));
  if (window.step_256 < 1) throw Error(ErrorKind::usage, "window: expected a step of at least 1/256 texel, found 0");
  const auto side_256 = [](int side) { return static_cast<uint32_t>(side) * 256u; };
  if (window.origin_x.offset_256 >= side_256(tile_size.x) || window.origin_y.offset_256 >= side_256(tile_size.y))
    throw Error(ErrorKind::usage, "window: expected an origin inside its tile");
  const uint64_t longest = static_cast<uint64_t>(std::max(window.width, window.height));
  if (longest * window.step_256 + side_256(std::max(tile_size.x, tile_size.y)) > std::numeric_limits<uint32_t>::max())
    throw Error(ErrorKind::usage, fmt::format("window: expected fewer than 16777216 texels on each side, found {} "
                                              "pixels of {}/256 texels; draw it in parts",
                                              longest, window.step_256));
}

int level_256_of(double texels, Filter filter, int level_count) {
  if (filter == Filter::nearest || filter == Filter::bilinear || texels <= 1) return 0;
  const double level = portable_log(texels) / portable_log(2);
  return std::min(static_cast<int>(std::lround(256 * level)), 256 * (level_count + 1));
}

int level_256_of(const Window& window, int level_count) {
  return level_256_of(window.step_256 / 256.0, window.filter, level_count);
}

}  // namespace texbake
