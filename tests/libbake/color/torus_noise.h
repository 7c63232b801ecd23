// Test pictures that tile by construction.
#pragma once

#include <algorithm>

#include "libbake/base/gaussian.h"
#include "libbake/base/image.h"
#include "libbake/base/random.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Blurred noise on the torus: a texture of blobs of `sigma_px`, channels independent, in 0 … 1, with a little grain.
inline Image<V3f> torus_noise(int width, int height, double sigma_px, uint64_t seed) {
  Random random(seed);
  Image<V3f> noise(width, height);
  for (V3f& texel : noise) texel = {random.uniform() - 0.5f, random.uniform() - 0.5f, random.uniform() - 0.5f};
  Image<V3f> smooth = gaussian_blur(noise, sigma_px, Wrap::repeat);
  for (size_t i = 0; i < smooth.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const float value =
          0.5f + smooth.data()[i][c] * static_cast<float>(2 * sigma_px) + 0.05f * (random.uniform() - 0.5f);
      smooth.data()[i][c] = std::min(std::max(value, 0.0f), 1.0f);
    }
  return smooth;
}

/// The window of an endless repetition of `tile` that starts at `begin`.
template <class T>
Image<T> window_of(const Image<T>& tile, V2i begin, int width, int height) {
  Image<T> window(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      window(x, y) = tile(wrap(begin.x + x, tile.width()), wrap(begin.y + y, tile.height()));
  return window;
}

}  // namespace texbake
