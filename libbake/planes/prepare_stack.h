// Puts the planes of several scales together, as shaders/scales.glsl reads them.
#pragma once

#include <vector>

#include "libbake/planes/stack_planes.h"
#include "libbake/planes/stack_scale.h"

namespace texbake {

/// Throws Error(bad_data) where prepare does, for more than kMaxScales scales, noise in a scale that is not the finest,
/// a scale without fragments or colors beside others, a ratio out of range, lists of weights of another length than
/// the palette, or a tile that is larger than that of the coarser scale: the scales are then in the wrong order.
StackPlanes prepare_stack(const std::vector<StackScale>& scales);

/// Throws Error(bad_data) unless `fine` can follow `coarse` with `transfer`; a part of prepare_stack that costs
/// nothing.
void check_transfer(const StackScale& coarse, const StackScale& fine);

}  // namespace texbake
