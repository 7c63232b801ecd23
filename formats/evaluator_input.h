// Hands the parts of a bundle to the evaluator.
#pragma once

#include "formats/bundle.h"
#include "libbake/planes/stack_scale.h"

namespace texbake {

/// What the evaluator reads of the finest scale of `bundle`: views into it, which must not outlive it. Its height map,
/// where there is one, is the map "height". A structure without spectra is drawn alone.
EvaluatorInput evaluator_input(const Bundle& bundle);

/// The same of any scale, without noise.
EvaluatorInput evaluator_input(const Scale& scale);

/// The same of all scales, coarse to fine. A stack has noise in its finest scale alone: the others show their
/// exemplars.
std::vector<StackScale> stack_input(const Bundle& bundle);

}  // namespace texbake
