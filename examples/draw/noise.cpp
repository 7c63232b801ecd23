#include "examples/draw/noise.h"

#include <cmath>

#include "libbake/base/random.h"

namespace texbake {
namespace {

/// Mixes all bits of its input. Based on: Wellons 2018, "lowbias32".
uint32_t mix_bits(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352dU;
  x = (x ^ (x >> 15)) * 0x846ca68bU;
  return x ^ (x >> 16);
}

/// Slope along d of the lattice point (x, y), one of 16 directions.
float slope(int x, int y, uint32_t seed, float dx, float dy) {
  const uint32_t bits = mix_bits(static_cast<uint32_t>(x) + mix_bits(static_cast<uint32_t>(y) + mix_bits(seed)));
  const float gx = static_cast<float>(bits & 255) / 127.5f - 1;
  const float gy = static_cast<float>((bits >> 8) & 255) / 127.5f - 1;
  return gx * dx + gy * dy;
}

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

float lerp(float a, float b, float w) { return a + (b - a) * w; }

}  // namespace

float gradient_noise(V2f p, int cells, uint32_t seed) {
  const V2f scaled = p * static_cast<float>(cells);
  const int x = static_cast<int>(std::floor(scaled.x)), y = static_cast<int>(std::floor(scaled.y));
  const float fx = scaled.x - static_cast<float>(x), fy = scaled.y - static_cast<float>(y);
  const int x0 = wrap(x, cells), x1 = wrap(x + 1, cells), y0 = wrap(y, cells), y1 = wrap(y + 1, cells);
  const float top = lerp(slope(x0, y0, seed, fx, fy), slope(x1, y0, seed, fx - 1, fy), fade(fx));
  const float bottom = lerp(slope(x0, y1, seed, fx, fy - 1), slope(x1, y1, seed, fx - 1, fy - 1), fade(fx));
  return 1.5f * lerp(top, bottom, fade(fy));
}

float fractal_noise(V2f p, int cells, int octaves, uint32_t seed) {
  float sum = 0, weight = 0.5f;
  for (int octave = 0; octave < octaves; ++octave, weight *= 0.5f, cells *= 2)
    sum += weight * gradient_noise(p, cells, seed + static_cast<uint32_t>(octave));
  return sum;
}

float hash_01(uint32_t key, uint32_t seed) {
  return static_cast<float>(mix_bits(key ^ mix_bits(seed)) >> 8) * 0x1p-24f;
}

}  // namespace texbake
