// One scale of a stack, before it is put together with the others.
#pragma once

#include <vector>

#include "libbake/planes/evaluator_input.h"
#include "libbake/planes/transfer.h"

namespace texbake {

/// One scale, coarse to fine.
struct StackScale {
  EvaluatorInput input;                     ///< noise: of the finest scale alone
  const ScaleTransfer* transfer = nullptr;  ///< nullptr for the coarsest alone
  V3f strength{1};                          ///< what its colors are multiplied with: set_strengths
};

/// Sets the strength of every scale, as its transfer asks for; a part of prepare_stack.
void set_strengths(std::vector<StackScale>& scales);

}  // namespace texbake
