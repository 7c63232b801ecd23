// Rounding to half float, the type in which colors, variations and masks are stored.
#pragma once

#include <Imath/half.h>

#include "libbake/base/torus.h"

namespace texbake {

inline constexpr float kLargestHalf = 65504;

/// The nearest half float, ties to even, as a float. Beyond ±65504 it is ±infinity: callers clamp first.
inline float half_exact(float x) { return static_cast<float>(Imath::half(x)); }
inline V3f half_exact(const V3f& c) { return {half_exact(c.x), half_exact(c.y), half_exact(c.z)}; }

}  // namespace texbake
