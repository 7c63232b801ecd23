#include "examples/draw/surface.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr float kReliefDepth = 0.1f;  // of the picture's width, for height 1
const V3f kSunDirection = V3f(-0.45f, -0.55f, 0.70f).normalized();
const V3f kSun(2.3f, 2.1f, 1.75f);
const V3f kSky(0.42f, 0.50f, 0.62f);

int bordered(int x, int n, Wrap border) { return border == Wrap::repeat ? wrap(x, n) : std::clamp(x, 0, n - 1); }

float height_at(const Surface& surface, int x, int y) {
  const V2i size = surface.size();
  return surface.height(bordered(x, size.x, surface.border), bordered(y, size.y, surface.border));
}

/// How far the sun is hidden at a texel: the highest the relief rises above the ray toward it.
float sunlight(const Surface& surface, int x, int y) {
  constexpr int kSteps = 24;
  const float depth_texels = kReliefDepth * static_cast<float>(surface.size().x);
  const float own = surface.height(x, y) * depth_texels;
  float hidden = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const auto along = static_cast<float>(i) * static_cast<float>(surface.size().x) / 1024.0f;
    const int sx = x + static_cast<int>(std::lround(kSunDirection.x * along));
    const int sy = y + static_cast<int>(std::lround(kSunDirection.y * along));
    const float ray = own + along * kSunDirection.z;
    hidden = std::max(hidden, (height_at(surface, sx, sy) * depth_texels - ray) / (0.5f + 0.15f * along));
  }
  return 1 - 0.85f * std::clamp(hidden, 0.0f, 1.0f);
}

template <class T>
Image<T> mean_of_four(ImageView<const T> image) {
  Image<T> half(image.width() / 2, image.height() / 2);
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x)
      half(x, y) =
          (image(2 * x, 2 * y) + image(2 * x + 1, 2 * y) + image(2 * x, 2 * y + 1) + image(2 * x + 1, 2 * y + 1)) *
          0.25f;
  return half;
}

}  // namespace

Image<V3f> normals(const Surface& surface) {
  const V2i size = surface.size();
  const float scale = kReliefDepth * static_cast<float>(size.x) * 0.5f;
  Image<V3f> normal(size.x, size.y);
  parallel_for(0, size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      const float dx = (height_at(surface, x + 1, y) - height_at(surface, x - 1, y)) * scale;
      const float dy = (height_at(surface, x, y + 1) - height_at(surface, x, y - 1)) * scale;
      normal(x, y) = V3f(-dx, dy, 1) / std::sqrt(dx * dx + dy * dy + 1);
    }
  });
  return normal;
}

Image<V3f> lit(const Surface& surface) {
  const V2i size = surface.size();
  const Image<V3f> normal = normals(surface);
  // A place that lies below its surroundings, near and wide, sees less of the sky.
  const Image<float> near = gaussian_blur(surface.height, size.x / 200.0, surface.border);
  const Image<float> wide = gaussian_blur(surface.height, size.x / 60.0, surface.border);
  Image<V3f> picture(size.x, size.y);
  parallel_for(0, size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      const V3f up(normal(x, y).x, -normal(x, y).y, normal(x, y).z);
      const float below = (near(x, y) - surface.height(x, y)) * 3 + (wide(x, y) - surface.height(x, y)) * 1.5f;
      const float open = std::clamp(0.85f - below, 0.12f, 1.0f);
      const float sun = std::max(0.0f, up.dot(kSunDirection)) * sunlight(surface, x, y);
      picture(x, y) = surface.albedo(x, y) * (kSun * (sun * (0.5f + 0.5f * open)) + kSky * open) * 0.55f;
    }
  });
  return picture;
}

Image<V3f> halved(ImageView<const V3f> image) { return mean_of_four(image); }
Image<float> halved(ImageView<const float> image) { return mean_of_four(image); }

V3f color(uint32_t srgb) {
  const auto channel = [&](int shift) { return linear_from_srgb(static_cast<float>((srgb >> shift) & 255) / 255.0f); };
  return {channel(16), channel(8), channel(0)};
}

float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace texbake
