#include "libbake/gl/material_parity.h"

#include "libbake/draw/drawing.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/prepare_stack.h"

namespace texbake {
namespace {

/// Texels between height 0 and 1: enough that rays meet the surface at a distance from where they enter.
constexpr float kReliefDepthPx = 16;

}  // namespace

ParityMaterial::ParityMaterial(const DrawnMaterial& material)
    : tile_(prepare(material.finest)), has_scales_(material.scales.size() > 1) {
  const EvaluatorInput& coarsest = material.scales.front().input;
  if (has_heights(coarsest)) {
    Relief relief;
    relief.options.depth_px = kReliefDepthPx;
    relief_ = relief_planes(coarsest, relief.options, relief.light);
  }
  if (has_scales_ || relief_) stack_ = prepare_stack(material.scales);
}

MaterialParity ParityMaterial::check(const GlContext& context, const ParityOptions& options) const {
  MaterialParity parity;
  if (has_scales_) {
    parity.report = check_stack_parity(*stack_, context, options);
  } else {
    parity.report = check_parity(tile_, context, options);
    parity.perspective = check_perspective_parity(tile_, context);
  }
  if (stack_) parity.perspective += check_stack_perspective_parity(*stack_, relief_ ? &*relief_ : nullptr, context);
  if (relief_) parity.relief = check_relief_parity(*stack_, *relief_, context);
  return parity;
}

}  // namespace texbake
