// Lichen on granite: two materials that differ in their grain, one fine and speckled, one soft and crumbly. What grows
// where has a shape, what it is made of has none: a texture of structure and noise. Tiles.
#include "examples/draw/noise.h"
#include "examples/draw/surface.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

/// How much lichen covers a point, 0 … 1: lobes with a frayed edge.
float cover(V2f p, uint32_t seed) {
  const float spread = fractal_noise(p, 6, 3, seed) + 0.12f * fractal_noise(p, 50, 3, seed + 10);
  return smooth_step(0.0f, 0.035f, spread);
}

V3f granite(V2f p, uint32_t seed) {
  const float speckle = gradient_noise(p, 230, seed) + 0.8f * gradient_noise(p, 410, seed + 1);
  return blend(color(0x4d4a4b), color(0xcfc4b8), smooth_step(-0.9f, 1.1f, speckle));
}

V3f lichen(V2f p, uint32_t seed) {
  const float crumb = gradient_noise(p, 95, seed) + 0.4f * gradient_noise(p, 210, seed + 1);
  return blend(color(0x8b7a23), color(0xd9c75a), smooth_step(-0.8f, 0.8f, crumb));
}

}  // namespace

Surface draw_lichen(int side, uint32_t seed) {
  Surface surface(side, side, Wrap::repeat);
  parallel_for(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const V2f p = surface.place(x, y);
      const float covered = cover(p, seed);
      surface.albedo(x, y) = blend(granite(p, seed + 20), lichen(p, seed + 30), covered);
      surface.height(x, y) = 0.05f + 0.03f * covered;
      surface.roughness(x, y) = 0.6f + 0.3f * covered;
    }
  });
  return surface;
}

}  // namespace texbake
