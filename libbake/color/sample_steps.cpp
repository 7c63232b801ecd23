#include "libbake/color/sample_steps.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr float kLeastNormalHalf = 0x1p-14f;
constexpr float kHalfOverflow = 65536;  ///< the half float that would follow the largest, and stands for infinity

/// Half floats count evenly within a binade of 1024, and from 0 to the least normal one.
float half_steps(float magnitude) {
  if (magnitude < kLeastNormalHalf) return magnitude * 0x1p24f;
  const float bounded = std::min(magnitude, kHalfOverflow);
  const int exponent = std::ilogb(bounded);
  return (static_cast<float>(exponent + 14) + std::ldexp(bounded, -exponent)) * 1024;
}

}  // namespace

float in_steps(float value, const SampleScale& scale) {
  if (std::isnan(value)) return value;
  const float highest = std::ldexp(1.0f, scale.bits) - 1;
  switch (scale.code) {
    case SampleCode::srgb:
      return std::clamp(srgb_from_linear(std::clamp(value, 0.0f, 1.0f)), 0.0f, 1.0f) * highest;
    case SampleCode::unit:
      return std::clamp(value, 0.0f, 1.0f) * highest;
    case SampleCode::vector:
      return std::clamp(value, -1.0f, 1.0f) * (std::ldexp(1.0f, scale.bits - 1) - 1);
    case SampleCode::half:
      return std::copysign(half_steps(std::abs(value)), value);
    case SampleCode::float32:
      break;
  }
  return value;
}

Image<V3f> in_steps(ImageView<const V3f> values, const SampleScale& scale) {
  Image<V3f> steps(values.width(), values.height());
  parallel_for(0, values.height(), [&](int y) {
    for (int x = 0; x < values.width(); ++x)
      for (int c = 0; c < 3; ++c) steps(x, y)[c] = in_steps(values(x, y)[c], scale);
  });
  return steps;
}

float default_tolerance(const SampleScale& scale) {
  switch (scale.code) {
    case SampleCode::half:
      return 1;
    case SampleCode::float32:
      return 0;
    default:
      return 0.6f;
  }
}

}  // namespace texbake
