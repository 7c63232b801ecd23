// How a noise covers the plane: its values follow one another along a row, and the next row begins a step further, so
// that they return along a lattice that lies askew to every tile. A periodic square would repeat with tiles of its
// side. Based on: rank-1 lattices (Niederreiter 1992, §5).
#pragma once

#include <cstdint>

#include "libbake/base/torus.h"

namespace texbake {

/// Texel (x, y) shows value (x + row_step · y) mod count. Both its coordinates wrap at 2^32.
struct NoiseLattice {
  int count = 0;     ///< of values, a power of two up to 2^24
  int row_step = 0;  ///< odd, below `count`

  uint32_t index(uint32_t x, uint32_t y) const {
    return (x + static_cast<uint32_t>(row_step) * y) & static_cast<uint32_t>(count - 1);
  }
  /// The frequency, in cycles per texel, −½ … ½, of k cycles per `count` values.
  Imath::V2d frequency(int k) const;
};

/// For side² values, side = 512, 1024, 2048 or 4096. A value returns at (x, y) only where |(x, y)| ≥ 0.98 side and, off
/// the axes, |x y| ≥ side² / 5. Tiles of 512 … 4096 texels show another part of the noise, at least 49 texels from the
/// first, in all repetitions near: 6 on each axis for tiles up to `side`, 3 for twice as large ones, 1 for larger ones.
NoiseLattice noise_lattice(int side);

}  // namespace texbake
