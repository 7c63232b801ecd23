// Levels of detail of a stack: of every scale by itself, and the fragments under their blocks, which take colors of
// the coarser scale. Based on: Lutz et al. 2019; Vanhoey et al. 2013, eq. 5. Layout: shaders/README.md, "Several
// scales".
#pragma once

#include "libbake/planes/stack_planes.h"
#include "libbake/planes/stack_scale.h"

namespace texbake {

/// A part of prepare_stack: adds the levels of `stack`, made from `scales`, whose strengths are set. Of the coarsest
/// scale all, of the others up to one block to a texel of the coarser scale, since they have faded into that then.
/// Throws Error(infeasible) when a scale has 2^32 values or more.
void add_levels(StackPlanes& stack, const std::vector<StackScale>& scales);

/// The level after which a scale of this ratio has faded: log2, rounded up.
int last_level(int ratio);

}  // namespace texbake
