// Compares the processor with the shader on OpenGL where rays are followed: in perspective, and in windows with relief.
// Where a ray meets the surface is found in floating point, so a share of pixels may differ; where both find the same,
// values must not differ in a bit.
#pragma once

#include <cstdint>

#include "libbake/gl/gl_renderer.h"

namespace texbake {

struct PerspectiveParity {
  uint64_t pixels = 0;
  uint64_t differing_sights = 0;  ///< place, level, axis or number of probes, or light differ
  uint64_t differing_values = 0;  ///< of the others: values differ in some bit

  PerspectiveParity& operator+=(const PerspectiveParity& more) {
    pixels += more.pixels;
    differing_sights += more.differing_sights;
    differing_values += more.differing_values;
    return *this;
  }

  /// Rays end in steps of 1/256 texel, near the last bits of a float far away, and drivers may round and fuse
  /// differently: one pixel in twenty.
  static constexpr double kTolerance = 0.05;
  bool equal() const {
    return differing_values == 0 && static_cast<double>(differing_sights) <= kTolerance * static_cast<double>(pixels);
  }
};

/// Views from near and far, with all filters, of base and maps of `planes`.
PerspectiveParity check_perspective_parity(const EvaluatorPlanes& planes, const GlContext& context);

/// The same of a stack, from heights at which each of its scales shows; with the relief of its coarsest scale where
/// that is given.
PerspectiveParity check_stack_perspective_parity(const StackPlanes& planes, const ReliefPlanes* relief,
                                                 const GlContext& context);

/// Windows of a stack with the relief of its coarsest scale, of every view of parity_views, seen from several
/// directions and from above.
PerspectiveParity check_relief_parity(const StackPlanes& planes, const ReliefPlanes& relief, const GlContext& context);

}  // namespace texbake
