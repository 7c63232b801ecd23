// A million points of a made-up tile, evaluated by the reference text alone: no library, no floating-point input but
// what integers give, so that a compiler's handling of the text is all that can differ.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/reference/program.h"

namespace texbake::parity {

constexpr int kWidth = 61, kHeight = 88;  ///< of the tile
constexpr int kPatches = 23, kContents = 7;
constexpr int kWindows = 16, kSide = 256;

class Numbers {
 public:
  explicit Numbers(uint32_t seed) : state_(seed) {}
  uint32_t below(uint32_t n) {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<uint32_t>((static_cast<uint64_t>(state_) * n) >> 32);
  }

 private:
  uint32_t state_;
};

struct Tile {
  std::vector<glsl::PatchTexel> patch_plane;
  std::vector<glsl::ivec4> contents, centers;
  std::vector<glsl::vec4> base;
};

/// Any owner and patch at any texel: not a partition, but every case of the arithmetic.
inline Tile made_up_tile() {
  // 65536 (cos θ, −sin θ) / λ for θ = 0, π/4, …, and λ = 1, 0.75, 0.5.
  constexpr int kMatrices[][3] = {{65536, 0, 65536},     {65536, 0, 65536},  {46341, -46341, 65536},
                                  {0, -65536, 65536},    {-65536, 0, 65536}, {61788, 61788, 49152},
                                  {0, 87381, 49152},     {131072, 0, 32768}, {-92682, -92682, 32768},
                                  {-92682, 92682, 32768}};
  Numbers numbers(12345);
  Tile tile;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const uint32_t owner = numbers.below(3) | numbers.below(3) << 2;
    tile.patch_plane.push_back({static_cast<uint16_t>(numbers.below(kPatches)), static_cast<uint16_t>(owner)});
    const auto half = [&] { return static_cast<float>(static_cast<int>(numbers.below(4096)) - 512) * 0x1p-11f; };
    const float r = half(), g = half(), b = half();
    tile.base.emplace_back(r, g, b, half());
  }
  for (int i = 0; i < kPatches * kContents; ++i) {
    const auto& m = kMatrices[numbers.below(10)];
    const int t = static_cast<int>(numbers.below(kWidth) | numbers.below(kHeight) << 16);
    tile.contents.push_back({t, m[2], m[0], m[1]});
  }
  for (int i = 0; i < kPatches; ++i) {
    const int x = static_cast<int>(numbers.below(kWidth));
    tile.centers.push_back({x, static_cast<int>(numbers.below(kHeight)), 0, 0});
  }
  return tile;
}

struct Patchwork {
  glsl::Position origin;
  uint32_t step_256;
  uint32_t seed;
  bool bilinear;
  int plane_kind;  ///< as in shaders/reference.frag: plain, normals up, normals down, height
};

inline std::vector<Patchwork> windows() {
  constexpr uint32_t kTiles[] = {0, 0xffffffffu, 0x7fffffffu, 0x80000000u, 0xfffffff8u, 0xfffffffdu, 123456789u};
  Numbers numbers(777);
  std::vector<Patchwork> all;
  for (int i = 0; i < kWindows; ++i) {
    Patchwork w;
    w.origin.tile.x = kTiles[numbers.below(7)];
    w.origin.tile.y = kTiles[numbers.below(7)];
    w.origin.offset.x = static_cast<int>(numbers.below(kWidth * 256));
    w.origin.offset.y = static_cast<int>(numbers.below(kHeight * 256));
    w.step_256 = 20 + numbers.below(i % 3 == 0 ? 3000 : 300);
    w.seed = numbers.below(0xffffffffu);
    w.bilinear = i % 4 != 3;
    w.plane_kind = i % 8 < 5 ? 0 : i % 8 - 4;
    all.push_back(w);
  }
  return all;
}

/// One pixel: a value and its decision, as the GPU's two targets hold them.
struct Pixel {
  glsl::vec4 value;
  uint32_t decided[4];
};

inline glsl::vec4 value_of(glsl::Program& p, const Patchwork& w, const glsl::Source& source, const glsl::Position& at) {
  const float up = w.plane_kind == 1 ? 1.0f : -1.0f;
  const bool is_normal = w.plane_kind == 1 || w.plane_kind == 2;
  if (!w.bilinear)
    return is_normal           ? p.source_normal(p.base, source, up)
           : w.plane_kind == 3 ? p.source_height(p.base, source)
                               : p.source_value(p.base, source);
  const glsl::Footprint footprint = p.footprint_at(at);
  return is_normal           ? p.footprint_normal(p.base, footprint, up)
         : w.plane_kind == 3 ? p.footprint_height(p.base, footprint)
                             : p.footprint_value(p.base, footprint);
}

/// All windows, row by row: 2^20 pixels.
inline std::vector<Pixel> evaluate() {
  const Tile tile = made_up_tile();
  glsl::Program p;
  p.patch_plane = {tile.patch_plane.data(), kWidth};
  p.contents = {tile.contents.data(), kContents};
  p.centers = {tile.centers.data(), kPatches};
  p.base = {tile.base.data(), kWidth};
  p.tile_size = {kWidth, kHeight};
  p.content_count = kContents;
  std::vector<Pixel> pixels;
  for (const Patchwork& w : windows()) {
    p.seed = w.seed;
    for (uint32_t j = 0; j < kSide; ++j)
      for (uint32_t i = 0; i < kSide; ++i) {
        const glsl::Position at = p.pixel_position(w.origin, w.step_256, {i, j});
        const glsl::Texel texel = p.texel_at(at);
        const glsl::Decision d = p.decide(texel);
        const glsl::Source s = p.source_of(texel, d);
        pixels.push_back({value_of(p, w, s, at),
                          {static_cast<uint32_t>(d.patch_idx), static_cast<uint32_t>(d.content),
                           static_cast<uint32_t>(s.nearest.x), static_cast<uint32_t>(s.nearest.y)}});
      }
  }
  return pixels;
}

}  // namespace texbake::parity
