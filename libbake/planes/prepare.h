// Turns what the stages found into the planes and tables that the evaluator reads, on the processor and on the GPU
// alike. The layout is specified in shaders/README.md.
#pragma once

#include "libbake/planes/evaluator_input.h"

namespace texbake {

/// Adds the levels of all planes where borders are soft, which are drawn from them. Throws Error(bad_data) when planes
/// differ in size, a side exceeds kMaxTileSide, a table does not fit its planes, or borders are too wide.
EvaluatorPlanes prepare(const EvaluatorInput& input);

/// Throws Error(bad_data) where a tile of this size cannot have borders so soft.
void check_soft_border_fits(int width_px, V2i size);

}  // namespace texbake
