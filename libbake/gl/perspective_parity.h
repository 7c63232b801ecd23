// Compares the processor with the shader of the perspective view on OpenGL. Where a ray meets the plane is found in
// floating point, so a share of pixels may differ; where both find the same, values must not differ in a bit.
#pragma once

#include <cstdint>

#include "libbake/gl/gl_renderer.h"
#include "libbake/gl/gl_stack_renderer.h"

namespace texbake {

struct PerspectiveParity {
  uint64_t pixels = 0;
  uint64_t differing_sights = 0;  ///< place, level, axis or number of probes differ
  uint64_t differing_values = 0;  ///< of the others: values differ in some bit

  /// Rays end in steps of 1/256 texel, near the last bits of a float far away, and drivers may round and fuse
  /// differently: one pixel in twenty.
  static constexpr double kTolerance = 0.05;
  bool equal() const {
    return differing_values == 0 && static_cast<double>(differing_sights) <= kTolerance * static_cast<double>(pixels);
  }
};

/// Views from near and far, with all filters, of base and maps of `planes`, whose levels were added.
PerspectiveParity check_perspective_parity(const EvaluatorPlanes& planes, const GlContext& context);

/// The same of a stack, from heights at which each of its scales shows; with the relief of its coarsest scale where
/// that is given.
PerspectiveParity check_stack_perspective_parity(const StackPlanes& planes, const ReliefPlanes* relief,
                                                 const GlContext& context);

}  // namespace texbake
