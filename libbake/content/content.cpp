#include "libbake/content/content.h"

#include <cassert>
#include <cmath>

namespace texbake {
namespace {

// cos of multiples of π/4.
constexpr double kHalfRoot = 0.70710678118654752440;
constexpr double kCosines[8] = {1, kHalfRoot, 0, -kHalfRoot, -1, -kHalfRoot, 0, kHalfRoot};

int32_t fixed_16(double x) { return static_cast<int32_t>(std::floor(65536.0 * x + 0.5)); }

}  // namespace

Content make_content(V2i translation, int rotation_eighths, float scale) {
  assert(rotation_eighths >= 0 && rotation_eighths < 8 && scale >= 0.5f && scale <= 1.0f);
  Content content;
  content.translation = translation;
  content.rotation_eighths = rotation_eighths;
  content.scale = scale;
  content.a = fixed_16(kCosines[rotation_eighths] / static_cast<double>(scale));
  content.b = fixed_16(kCosines[(rotation_eighths + 2) % 8] / static_cast<double>(scale));  // −sin θ = cos(θ + π/2)
  return content;
}

}  // namespace texbake
