// A forest floor in autumn: fallen leaves over soil, cropped as a photograph is. Does not tile.
#include <algorithm>
#include <cmath>

#include "examples/draw/noise.h"
#include "examples/draw/surface.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

struct Leaf {
  V2f center;
  V2f axis;
  float length;  ///< half of it
  float width;   ///< half of it, over length
  float bend;
  float level;  ///< height of its place in the pile
  V3f blade, edge, vein;
  uint32_t seed;
};

Leaf random_leaf(Random& random, float level) {
  struct Hue {
    V3f blade, edge;
  };
  static const Hue kHues[] = {{color(0xc8641e), color(0x8f3414)}, {color(0xd9a032), color(0xa8661c)},
                              {color(0x9c2f1c), color(0x5f1c14)}, {color(0x8a5a34), color(0x573620)},
                              {color(0x7d8a35), color(0xb39a34)}, {color(0x6b4a33), color(0x412c20)},
                              {color(0xe0b85a), color(0xb9772a)}, {color(0xb04a20), color(0xd08a2c)}};
  Leaf leaf{};
  leaf.center = {1.3f * random.uniform() - 0.15f, 1.3f * random.uniform() - 0.15f};
  const double angle = 6.283185307 * random.uniform();
  leaf.axis = {static_cast<float>(portable_cos(angle)), static_cast<float>(portable_sin(angle))};
  leaf.length = 0.035f + 0.040f * random.uniform();
  leaf.width = 0.34f + 0.22f * random.uniform();
  leaf.bend = 0.5f * random.uniform() - 0.25f;
  leaf.level = level;
  const Hue& hue = kHues[random.below(8)];
  const float shade = 0.75f + 0.4f * random.uniform();
  leaf.blade = hue.blade * shade;
  leaf.edge = hue.edge * shade;
  leaf.vein = blend(leaf.blade, color(0xe6cf96), 0.55f);
  leaf.seed = random.next();
  return leaf;
}

/// Coordinates on a leaf: u from −1 (stalk) to 1 (tip), v across, ±1 on the outline.
V2f on_leaf(const Leaf& leaf, V2f d) {
  const float u = d.dot(leaf.axis) / leaf.length;
  const float across = (d.y * leaf.axis.x - d.x * leaf.axis.y) / leaf.length - leaf.bend * (u * u - 0.5f);
  // Widest below the middle, pointed at the tip, finely toothed.
  const float t = std::clamp(0.5f * (u + 1), 0.0f, 1.0f);
  const float body = 2.6f * std::sqrt(t) * (1 - t) * (1 + 0.25f * t);
  const float tooth = 1 + 0.05f * static_cast<float>(portable_sin(46.0 * t)) * (1 - t);
  const float half_width = leaf.width * body * tooth;
  return {u, half_width > 1e-3f ? across / half_width : 9.0f};
}

/// 1 on the middle rib and the side ribs that leave it, 0 between.
float ribs(V2f on, float width) {
  const float v = std::fabs(on.y);
  const float middle = 1 - smooth_step(0.02f, 0.07f, v);
  const float along = (on.x - 0.75f * v * width) * 4.5f;
  const float off = std::fabs(along - std::round(along));
  return std::max(middle, 0.6f * (1 - smooth_step(0.03f, 0.12f, off)) * (1 - 0.6f * v));
}

void draw_soil(Surface& surface, uint32_t seed) {
  parallel_for(0, surface.size().y, [&](int y) {
    for (int x = 0; x < surface.size().x; ++x) {
      const V2f p = surface.place(x, y);
      const float crumbs = fractal_noise(p, 40, 5, seed);
      surface.albedo(x, y) = blend(color(0x2a2019), color(0x55412f), std::clamp(0.5f + 1.2f * crumbs, 0.0f, 1.0f));
      surface.height(x, y) = 0.06f + 0.05f * crumbs;
    }
  });
}

void draw_leaf(Surface& surface, const Leaf& leaf) {
  stamp(surface, leaf.center, leaf.length * 1.25f, [&](V2f d, int x, int y) {
    const V2f on = on_leaf(leaf, d);
    const float v = std::fabs(on.y);
    const V2f p = surface.place(x, y);
    const bool stalk =
        on.x < -0.9f && on.x > -1.25f &&
        std::fabs((d.y * leaf.axis.x - d.x * leaf.axis.y) / leaf.length - leaf.bend * (on.x * on.x - 0.5f)) < 0.025f;
    if (!stalk && (v >= 1 || std::fabs(on.x) >= 1)) return;
    const float curl = 0.05f * (on.x * on.x) + 0.035f * (stalk ? 0.0f : v * v);
    const float rib = stalk ? 1.0f : ribs(on, leaf.width);
    const float height = leaf.level + curl + 0.010f * rib + 0.02f * fractal_noise(p, 22, 3, leaf.seed);
    if (height <= surface.height(x, y)) return;
    const float blotch = fractal_noise(p, 18, 5, leaf.seed);
    V3f albedo = blend(leaf.blade, leaf.edge, smooth_step(0.25f, 1.0f, (stalk ? 0.0f : v) + 0.9f * blotch));
    albedo *= 1 + 0.25f * gradient_noise(p, 160, leaf.seed + 1);
    const float spot = smooth_step(0.42f, 0.55f, gradient_noise(p, 70, leaf.seed + 2));
    albedo = blend(albedo, color(0x35231a), 0.7f * spot);
    surface.albedo(x, y) = blend(albedo, leaf.vein, 0.65f * rib);
    surface.height(x, y) = height;
    surface.roughness(x, y) = 0.6f;
  });
}

}  // namespace

Surface draw_leaves(int side, uint32_t seed) {
  Surface surface(side, side * 7 / 8, Wrap::clamp);
  draw_soil(surface, seed);
  Random random(seed, 2);
  constexpr int kLeaves = 420;
  for (int i = 0; i < kLeaves; ++i)
    draw_leaf(surface, random_leaf(random, 0.10f + 0.35f * static_cast<float>(i) / kLeaves));
  return surface;
}

}  // namespace texbake
