#include "libbake/draw/window_part.h"

namespace texbake {
namespace {

/// `from` and `distance_256` further; repetitions wrap modulo 2^32.
TileOffset advanced(const TileOffset& from, uint64_t distance_256, int tile_side) {
  const uint64_t side_256 = static_cast<uint64_t>(tile_side) * 256;
  const uint64_t offset = from.offset_256 + distance_256;
  return {from.tile + static_cast<uint32_t>(offset / side_256), static_cast<uint32_t>(offset % side_256)};
}

}  // namespace

Window part_of(const Window& window, V2i tile_size, V2i first, V2i size) {
  Window part = window;
  part.origin_x = advanced(window.origin_x, static_cast<uint64_t>(first.x) * window.step_256, tile_size.x);
  part.origin_y = advanced(window.origin_y, static_cast<uint64_t>(first.y) * window.step_256, tile_size.y);
  part.width = size.x;
  part.height = size.y;
  return part;
}

WindowPoint point_of(const Window& window, V2i tile_size, V2i pixel) {
  const Window part = part_of(window, tile_size, pixel, {1, 1});
  return {advanced(part.origin_x, window.step_256 / 2, tile_size.x),
          advanced(part.origin_y, window.step_256 / 2, tile_size.y)};
}

}  // namespace texbake
