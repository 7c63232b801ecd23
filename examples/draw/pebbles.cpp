// River pebbles of many stones and sizes, washed together on dark sand. Tiles.
#include <algorithm>
#include <cmath>
#include <vector>

#include "examples/draw/noise.h"
#include "examples/draw/surface.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Stone {
  V3f light, dark;
  bool veined;
};

struct Pebble {
  V2f center;
  float radius;
  V2f axis;         ///< unit, along its length
  float flatness;   ///< width over length
  float wobble[6];  ///< amplitudes and phases of its outline
  Stone stone;
  uint32_t seed;
};

Stone random_stone(Random& random) {
  // Slate, basalt, granite, sandstone, brick-red jasper, greenstone, white quartz.
  static const Stone kStones[] = {{color(0x77828c), color(0x48525c), true},  {color(0x4a4b50), color(0x2c2d32), false},
                                  {color(0xa59c92), color(0x6f675f), false}, {color(0xc09a6b), color(0x8a6238), false},
                                  {color(0x8f5848), color(0x5c382e), true},  {color(0x75836a), color(0x46523f), false},
                                  {color(0xd9d2c4), color(0xaaa090), false}, {color(0x8c8a93), color(0x5b5964), true}};
  const uint32_t weighted[] = {0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 4, 5, 6, 7, 7, 7};
  Stone stone = kStones[weighted[random.below(16)]];
  const float shade = 0.85f + 0.3f * random.uniform();
  stone.light *= shade;
  stone.dark *= shade;
  return stone;
}

Pebble random_pebble(Random& random, float radius) {
  Pebble pebble{};
  pebble.center = {random.uniform(), random.uniform()};
  pebble.radius = radius * (0.8f + 0.4f * random.uniform());
  const double angle = kPi * random.uniform();
  pebble.axis = {static_cast<float>(portable_cos(angle)), static_cast<float>(portable_sin(angle))};
  pebble.flatness = 0.62f + 0.33f * random.uniform();
  for (int k = 0; k < 3; ++k) {
    pebble.wobble[2 * k] = 0.10f * random.uniform() / static_cast<float>(k + 1);
    pebble.wobble[2 * k + 1] = 6.28f * random.uniform();
  }
  pebble.stone = random_stone(random);
  pebble.seed = random.next();
  return pebble;
}

bool has_room(const Pebble& pebble, const std::vector<Pebble>& others) {
  return std::all_of(others.begin(), others.end(), [&](const Pebble& other) {
    V2f d = pebble.center - other.center;
    d -= V2f(std::round(d.x), std::round(d.y));
    const float reach = 0.80f * (pebble.radius + other.radius) * 0.9f;
    return d.dot(d) > reach * reach;
  });
}

std::vector<Pebble> scatter(uint32_t seed) {
  Random random(seed, 1);
  std::vector<Pebble> pebbles;
  struct Layer {
    float radius;
    int attempts;
  };
  for (const Layer layer : {Layer{0.066f, 60}, {0.044f, 260}, {0.028f, 900}, {0.016f, 2600}, {0.0085f, 5000}})
    for (int attempt = 0; attempt < layer.attempts; ++attempt) {
      const Pebble pebble = random_pebble(random, layer.radius);
      if (has_room(pebble, pebbles)) pebbles.push_back(pebble);
    }
  return pebbles;
}

/// 1 at the center, 0 on the outline, negative outside.
float inside(const Pebble& pebble, V2f d) {
  const float u = d.dot(pebble.axis) / pebble.radius;
  const float v = (d.y * pebble.axis.x - d.x * pebble.axis.y) / (pebble.radius * pebble.flatness);
  const float r = std::sqrt(u * u + v * v);
  if (r < 1e-4f) return 1;
  // cos kθ from cos θ and sin θ; the phases turn each lobe.
  const float c = u / r, s = v / r;
  const float c2 = c * c - s * s, s2 = 2 * c * s, c3 = c2 * c - s2 * s, s3 = s2 * c + c2 * s;
  const float lobes[3][2] = {{c2, s2}, {c3, s3}, {c2 * c2 - s2 * s2, 2 * c2 * s2}};
  float outline = 1;
  for (int k = 0; k < 3; ++k) {
    const double phase = pebble.wobble[2 * k + 1];
    outline += pebble.wobble[2 * k] * (lobes[k][0] * static_cast<float>(portable_cos(phase)) +
                                       lobes[k][1] * static_cast<float>(portable_sin(phase)));
  }
  return 1 - r / outline;
}

V3f stone_color(const Pebble& pebble, V2f place) {
  const float mottle = fractal_noise(place, 24, 5, pebble.seed);
  V3f albedo = blend(pebble.stone.dark, pebble.stone.light, std::clamp(0.6f + 0.9f * mottle, 0.0f, 1.0f));
  const float speck = gradient_noise(place, 300, pebble.seed + 77);
  albedo *= 1 + 0.28f * speck;
  if (pebble.stone.veined && hash_01(pebble.seed, 5) < 0.5f) {
    // Quartz has filled a crack: a thin line where a slow noise passes zero.
    const float vein = std::fabs(gradient_noise(place, 9, pebble.seed + 3) + 0.25f * gradient_noise(place, 40, 9));
    albedo = blend(color(0xd8d4cb), albedo, smooth_step(0.015f, 0.05f, vein));
  }
  return albedo;
}

void draw_sand(Surface& surface, uint32_t seed) {
  parallel_for(0, surface.size().y, [&](int y) {
    for (int x = 0; x < surface.size().x; ++x) {
      const V2f p = surface.place(x, y);
      const float grain = gradient_noise(p, 420, seed);
      const float damp = fractal_noise(p, 6, 4, seed + 9);
      surface.albedo(x, y) =
          blend(color(0x5b4a38), color(0x8d7757), std::clamp(0.5f + damp + 0.6f * grain, 0.0f, 1.0f));
      surface.height(x, y) = 0.10f + 0.03f * damp + 0.012f * grain;
    }
  });
}

}  // namespace

Surface draw_pebbles(int side, uint32_t seed) {
  Surface surface(side, side, Wrap::repeat);
  draw_sand(surface, seed);
  for (const Pebble& pebble : scatter(seed))
    stamp(surface, pebble.center, pebble.radius * 1.3f, [&](V2f d, int x, int y) {
      const float in = inside(pebble, d);
      if (in <= 0) return;
      const V2f place = surface.place(x, y);
      const float dome = std::sqrt(std::min(1.0f, in * (2 - in)));
      const float height = 0.06f + pebble.radius * 7.5f * dome + 0.012f * fractal_noise(place, 60, 3, pebble.seed);
      if (height <= surface.height(x, y)) return;
      surface.height(x, y) = height;
      surface.albedo(x, y) = stone_color(pebble, place);
      surface.roughness(x, y) = 0.35f + 0.25f * hash_01(pebble.seed, 8);
    });
  return surface;
}

}  // namespace texbake
