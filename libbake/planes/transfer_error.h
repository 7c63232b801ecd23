// How well the mean of fine texels keeps the coarse color that they were given.
// Based on: Vanhoey et al. 2013, §6, eq. 4, which eq. 5 meets only approximately.
#pragma once

#include "libbake/planes/stack_planes.h"

namespace texbake {

struct TransferError {
  double rms = 0;    ///< over coarse texels and channels, linear light: mean of the fine texels less the coarse texel
  double worst = 0;  ///< of one channel of one coarse texel
  int coarse_texels = 0;
  double below_black = 0;  ///< share of the fine texels that have a channel below -1/255: they are clipped when stored
};

/// Coarse texels along each axis: of so many, the rms is known to one or two percent.
inline constexpr int kTransferErrorSide = 48;

/// Measured on side × side coarse texels of the infinite texture from the origin on, seed 0, between `scale` ≥ 1 and
/// the one before it.
TransferError transfer_error(const StackPlanes& planes, int scale, int side = kTransferErrorSide);

}  // namespace texbake
