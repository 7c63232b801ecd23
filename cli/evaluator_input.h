// Hands the parts of a bundle to the evaluator.
#pragma once

#include "formats/bundle.h"
#include "libbake/eval/prepare.h"

namespace texbake {

/// What the evaluator reads of the finest scale of `bundle`: views into it, which must not outlive it. Its height map,
/// where there is one, is the map "height". A structure without spectra is drawn alone.
EvaluatorInput evaluator_input(const Bundle& bundle);

}  // namespace texbake
