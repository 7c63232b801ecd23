// Steps were searched for: of all whose continued fraction of step / count has no term above 4, which keeps repetitions
// from the axes, those that keep away from repetitions of tiles with sides of a power of two, and then from the fewest
// with other multiples of 64.
#include "libbake/noise/noise_lattice.h"

#include <cassert>

namespace texbake {

Imath::V2d NoiseLattice::frequency(int k) const {
  const auto y = static_cast<int>(static_cast<int64_t>(k) * row_step & (count - 1));
  return Imath::V2d(shortest(k, count), shortest(y, count)) / count;
}

NoiseLattice noise_lattice(int side) {
  switch (side) {
    case 512:
      return {512 * 512, 111111};
    case 1024:
      return {1024 * 1024, 402039};
    case 2048:
      return {2048 * 2048, 2591441};
    default:
      assert(side == 4096);
      return {4096 * 4096, 9902779};
  }
}

}  // namespace texbake
