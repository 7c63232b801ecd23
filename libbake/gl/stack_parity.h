// Compares the processor with the reference shader on OpenGL for a stack of scales.
#pragma once

#include "libbake/gl/parity.h"

namespace texbake {

/// Every scale by itself and fading into the one before it, with and without its variation, and at every level of
/// detail that was added, in turn.
std::vector<ScaleView> parity_views(const StackPlanes& planes);

/// The window with its pixels as many times as wide as texels of `scale` are beside those of the finest.
Window seen_from_afar(const StackPlanes& planes, const Window& window, int scale);

/// The windows of parity_windows, each with a view; more are drawn until every content of every scale was seen.
ParityReport check_stack_parity(const StackPlanes& planes, const GlContext& context, const ParityOptions& options = {});

}  // namespace texbake
