// Turns what the stages found into the planes and tables that the evaluator reads, on the processor and on the GPU
// alike. The layout is specified in shaders/README.md.
#pragma once

#include "libbake/planes/evaluator_input.h"

namespace texbake {

/// The planes and tables of `input`, with their levels of detail. Throws Error(bad_data) when planes differ in size, a
/// side exceeds kMaxTileSide, a table does not fit its planes, or borders are too wide; Error(infeasible) when levels
/// have 2^32 values or more.
EvaluatorPlanes prepare(const EvaluatorInput& input);

/// The same without levels: what relief and stacks begin with, which make levels of their own.
TilePlanes prepare_tile(const EvaluatorInput& input);

/// Throws Error(bad_data) where a tile of this size cannot have borders so soft.
void check_soft_border_fits(int width_px, V2i size);

}  // namespace texbake
