// A coordinate of the infinite texture, exact however far it is from the origin.
#pragma once

#include <cstdint>
#include <string_view>

namespace texbake {

/// Where a coordinate lies on one axis: the repetition of the tile, modulo 2^32, and the place there in 1/256 texel.
struct TileOffset {
  uint32_t tile = 0;
  uint32_t offset_256 = 0;  ///< 0 … 256 · tile side − 1
  bool operator==(const TileOffset&) const = default;
};

/// Coordinate `texels` + `fraction_256` / 256 of the infinite texture; any int64 and any fraction.
TileOffset tile_offset(int64_t texels, int64_t fraction_256, int tile_side);

/// The same from a decimal number of texels such as "-1048576.25", rounded to the nearest 1/256 (halves up), any number
/// of digits that fits int64. Throws Error(usage) otherwise; `option` names it in the message.
TileOffset tile_offset(std::string_view decimal_texels, int tile_side, std::string_view option);

}  // namespace texbake
