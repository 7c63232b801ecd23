// What is drawn of a material, before planes are made of it.
#pragma once

#include <vector>

#include "libbake/planes/evaluator_input.h"
#include "libbake/planes/stack_scale.h"

namespace texbake {

/// Views are borrowed from what holds the material.
struct DrawnMaterial {
  EvaluatorInput finest;           ///< the finest scale with its maps and noise, as it is drawn by itself
  std::vector<StackScale> scales;  ///< all scales, coarse to fine, as they are drawn together

  V2i tile_size() const { return {finest.base.width(), finest.base.height()}; }  ///< of the finest scale
};

}  // namespace texbake
