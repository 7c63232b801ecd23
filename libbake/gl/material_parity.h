// Compares the processor with the reference shader on OpenGL for everything that can be drawn of a material.
#pragma once

#include <optional>

#include "libbake/gl/perspective_parity.h"
#include "libbake/gl/stack_parity.h"
#include "libbake/planes/drawn_material.h"

namespace texbake {

/// What one driver gave in one language.
struct MaterialParity {
  ParityReport report;
  PerspectiveParity perspective = {};
  PerspectiveParity relief = {};  ///< windows with relief; nothing where there are no heights

  bool equal() const { return report.equal() && perspective.equal() && relief.equal(); }
};

/// A material, prepared once for several drivers and languages.
class ParityMaterial {
 public:
  /// Borrows what `material` views until it returns. Throws as prepare and prepare_stack do.
  explicit ParityMaterial(const DrawnMaterial& material);

  /// The color and every map of a material of one scale, or all scales of a stack together; where the coarsest scale
  /// has heights, with relief too.
  MaterialParity check(const GlContext& context, const ParityOptions& options = {}) const;

  V2i tile_size() const { return tile_.size; }

 private:
  EvaluatorPlanes tile_;
  std::optional<StackPlanes> stack_;  ///< of several scales, or of one with relief
  std::optional<ReliefPlanes> relief_;
  bool has_scales_;
};

}  // namespace texbake
