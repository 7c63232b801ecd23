// Row-major positions on the torus: what the inner loops of growing and cleaning step through.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libbake/base/torus.h"

namespace texbake {

/// A tile has less than 2^32 texels: 32-bit division is several times faster.
inline V2i texel_of(size_t at, V2i size) {
  const auto width = static_cast<uint32_t>(size.x), p = static_cast<uint32_t>(at);
  return {static_cast<int>(p % width), static_cast<int>(p / width)};
}
inline size_t position_of(V2i texel, V2i size) {
  return static_cast<size_t>(texel.y) * static_cast<size_t>(size.x) + static_cast<size_t>(texel.x);
}

/// The positions of the four neighbors of `p` on the torus, in the order of kNeighborX.
struct Neighbors {
  size_t at[4];
  Neighbors(size_t p, V2i size) {
    const auto width = static_cast<size_t>(size.x), height = static_cast<size_t>(size.y);
    const size_t x = static_cast<uint32_t>(p) % static_cast<uint32_t>(width), row = p - x;
    at[0] = x + 1 == width ? row : p + 1;
    at[1] = row + width == width * height ? x : p + width;
    at[2] = x == 0 ? row + width - 1 : p - 1;
    at[3] = row == 0 ? p + width * (height - 1) : p - width;
  }
};

}  // namespace texbake
