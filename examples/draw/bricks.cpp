// An old wall in running bond: fired bricks of many shades, chipped, in sandy mortar. Tiles.
#include <algorithm>
#include <cmath>

#include "examples/draw/noise.h"
#include "examples/draw/surface.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr int kRows = 12;
constexpr int kColumns = 5;
constexpr float kJoint = 0.011f;  // width of the mortar joints, of the picture's width

/// Where a point lies in the wall.
struct InWall {
  uint32_t brick;  ///< names the brick
  V2f from_center;
  float edge;  ///< distance to the brick's outline, positive inside; the corners are round
};

InWall locate(V2f p, uint32_t seed) {
  // The courses are laid by hand: joints waver a little.
  const V2f wavered = p + V2f(fractal_noise(p, 10, 3, seed), fractal_noise(p, 10, 3, seed + 50)) * 0.004f;
  const float row_height = 1.0f / kRows, brick_width = 1.0f / kColumns;
  const int row = static_cast<int>(std::floor(wavered.y / row_height));
  const float shift = (row & 1) ? 0.5f * brick_width : 0.0f;
  const int column = static_cast<int>(std::floor((wavered.x + shift) / brick_width));
  InWall in{};
  in.brick = static_cast<uint32_t>(wrap(row, kRows) * kColumns + wrap(column, kColumns));
  in.from_center = {wavered.x + shift - (static_cast<float>(column) + 0.5f) * brick_width,
                    wavered.y - (static_cast<float>(row) + 0.5f) * row_height};
  const float round = 0.008f;
  const float half_x = 0.5f * (brick_width - kJoint) - round, half_y = 0.5f * (row_height - kJoint) - round;
  const float dx = std::max(0.0f, std::fabs(in.from_center.x) - half_x);
  const float dy = std::max(0.0f, std::fabs(in.from_center.y) - half_y);
  const float beyond = std::max(std::fabs(in.from_center.x) - half_x, std::fabs(in.from_center.y) - half_y);
  in.edge = round - (beyond > 0 ? std::sqrt(dx * dx + dy * dy) : beyond);
  return in;
}

V3f brick_color(V2f p, uint32_t brick, uint32_t seed) {
  static const V3f kClays[] = {color(0x9c4a33), color(0xb0583a), color(0x8a3f2f), color(0xa8664a),
                               color(0x6f3a35), color(0xc07a52), color(0x7d4a3e)};
  const auto clay = static_cast<size_t>(hash_01(brick, seed) * 7);
  const float shade = 0.8f + 0.4f * hash_01(brick, seed + 1);
  const float mottle = fractal_noise(p, 16, 5, seed + brick);
  V3f albedo = kClays[clay] * shade * (1 + 0.7f * mottle);
  // The fire has darkened some; ash and sand left light specks.
  if (hash_01(brick, seed + 2) < 0.2f) albedo = blend(albedo, color(0x3a2d2c), 0.55f + 0.5f * mottle);
  const float speck = gradient_noise(p, 200, seed + 7);
  return blend(albedo, color(0xd2b79c), smooth_step(0.55f, 0.8f, speck) * 0.7f);
}

}  // namespace

Surface draw_bricks(int side, uint32_t seed) {
  Surface surface(side, side, Wrap::repeat);
  parallel_for(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const V2f p = surface.place(x, y);
      const InWall in = locate(p, seed);
      const float chips = 0.010f * smooth_step(0.1f, 0.5f, fractal_noise(p, 14, 4, seed + 11));
      const float rough = fractal_noise(p, 48, 4, seed + 13);
      const float brick = smooth_step(-0.0015f, 0.0015f, in.edge - chips + 0.002f * rough);

      const float sand = gradient_noise(p, 360, seed + 15);
      const float damp = std::clamp(0.5f + fractal_noise(p, 5, 4, seed + 17), 0.0f, 1.0f);
      const V3f mortar = blend(color(0x8f877b), color(0xbdb4a4), damp) * (1 + 0.22f * sand);
      V3f albedo = blend(mortar, brick_color(p, in.brick, seed), brick);
      // Lime has run down the wall in places.
      const float lime = smooth_step(0.28f, 0.6f, fractal_noise({p.x, p.y}, 3, 5, seed + 19));
      albedo = blend(albedo, color(0xcfc6b8), 0.45f * lime * std::clamp(0.6f + rough, 0.0f, 1.0f));

      const float proud = 0.03f * hash_01(in.brick, seed + 3);
      const float pits = 0.05f * smooth_step(0.45f, 0.7f, gradient_noise(p, 90, seed + 21));
      const float face = 0.34f + proud + 0.025f * rough - pits;
      const float rounded = 0.05f * smooth_step(0.010f, 0, in.edge - chips);
      surface.albedo(x, y) = albedo;
      surface.height(x, y) = std::max(0.14f + 0.012f * sand + 0.03f * rough, (face - rounded) * brick);
      surface.roughness(x, y) = 0.95f - 0.2f * brick;
    }
  });
  return surface;
}

}  // namespace texbake
