// The slow painter: works forward, tile by tile and patch by patch, and shares no line with the evaluator.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "small_tile.h"

namespace texbake {

/// A rectangle of the infinite texture, texel by texel. Coordinates are 64-bit: no repetition of the tile is folded.
struct Painting {
  int64_t x0 = 0, y0 = 0;
  Image<V3f> color;
  Image<V3f> structure;       ///< the color without noise
  Image<Imath::V4f> weights;  ///< of the noises; zeros without
  Image<int> patch;           ///< −1 where nothing was painted
  Image<int> content;
  Image<V2i> source;  ///< nearest texel of the tile
  Image<int> times;   ///< how often a texel was painted: 1 everywhere

  bool covers(int64_t x, int64_t y) const {
    return x >= x0 && y >= y0 && x < x0 + color.width() && y < y0 + color.height();
  }
};

class Painter {
 public:
  Painter(const SmallTile& tile, uint32_t seed) : tile_(tile), seed_(seed) {}

  Painting paint(int64_t x0, int64_t y0, int width, int height) const {
    Painting painting{x0,
                      y0,
                      Image<V3f>(width, height),
                      Image<V3f>(width, height),
                      Image<Imath::V4f>(width, height, Imath::V4f(0)),
                      Image<int>(width, height, -1),
                      Image<int>(width, height),
                      Image<V2i>(width, height),
                      Image<int>(width, height)};
    const V2i n = tile_.size();
    for (int64_t ky = floor_div(y0, n.y) - 1; ky <= floor_div(y0 + height, n.y) + 1; ++ky)
      for (int64_t kx = floor_div(x0, n.x) - 1; kx <= floor_div(x0 + width, n.x) + 1; ++kx)
        for (int patch = 0; patch < tile_.patches.partition.count(); ++patch) paint_patch(painting, kx, ky, patch);
    return painting;
  }

  /// Content of a patch in repetition (kx, ky), by 64-bit arithmetic modulo 2^32.
  int content_of(int patch, int64_t kx, int64_t ky) const {
    uint64_t h = permuted(seed_);
    h = permuted(modulo(h + modulo(static_cast<uint64_t>(ky))));
    h = permuted(modulo(h + modulo(static_cast<uint64_t>(kx))));
    h = permuted(modulo(h + static_cast<uint64_t>(patch)));
    return static_cast<int>(h / 65536 * static_cast<uint64_t>(tile_.contents.content_count) / 65536);
  }

  /// 2 √x as shaders/README.md has it: y = 1 / √x by two steps of Newton's method, 2 x y. 0 where x is not above 0.
  static float twice_root(float x) {
    if (!(x > 0)) return 0;
    const float half = x / 2;
    float y = std::bit_cast<float>(0x5f37'59dfu - std::bit_cast<uint32_t>(x) / 2);
    y *= 1.5f - half * y * y;
    y *= 1.5f - half * y * y;
    return 2 * (x * y);
  }

  /// Which value of a noise, in reading order, the texel (x, y) of the infinite texture shows: one more for each texel
  /// to the right, noise_step more for each row, and so backwards.
  size_t noise_number(const Image<V3f>& noise, int64_t x, int64_t y) const {
    const auto count = static_cast<int64_t>(noise.size());
    const auto rest = [count](int64_t n) { return (n % count + count) % count; };
    return static_cast<size_t>(rest(rest(x) + tile_.noise_step * rest(y)));
  }

  static int64_t floor_div(int64_t a, int64_t b) {
    return static_cast<int64_t>(std::floor(static_cast<double>(a) / static_cast<double>(b)));
  }

 private:
  static uint64_t modulo(uint64_t x) { return x % 4294967296; }
  static uint64_t permuted(uint64_t x) {
    const uint64_t state = modulo(x * 747796405 + 2891336453);
    const uint64_t shift = state / 268435456 + 4;
    const uint64_t word = modulo(((state >> shift) ^ state) * 277803737);
    return (word / 4194304) ^ word;
  }

  /// Every texel within half a tile of the center that bears the patch's number is of this patch: a patch is smaller.
  void paint_patch(Painting& painting, int64_t kx, int64_t ky, int patch) const {
    const V2i n = tile_.size();
    const V2i c = tile_.patches.partition.centers[static_cast<size_t>(patch)];
    const int number = content_of(patch, kx, ky);
    const Content& content = tile_.contents.at(patch, number);
    for (int dy = -n.y / 2; dy <= (n.y - 1) / 2; ++dy)
      for (int dx = -n.x / 2; dx <= (n.x - 1) / 2; ++dx) {
        const int64_t x = kx * n.x + c.x + dx, y = ky * n.y + c.y + dy;
        if (!painting.covers(x, y)) continue;
        const V2i at = wrap(V2i(c.x + dx, c.y + dy), n);
        if (tile_.patches.partition.idx(at.x, at.y) != static_cast<uint32_t>(patch)) continue;
        const int i = static_cast<int>(x - painting.x0), j = static_cast<int>(y - painting.y0);
        painting.color(i, j) = content_color(tile_.base, content, c, dx, dy);
        painting.structure(i, j) = painting.color(i, j);
        painting.weights(i, j) = weights_of(content, c, V2i(dx, dy));
        add_noise(painting.color(i, j), painting.weights(i, j), x, y);
        painting.patch(i, j) = patch;
        painting.content(i, j) = number;
        painting.source(i, j) = nearest_source(content, c, dx, dy);
        ++painting.times(i, j);
      }
  }

  /// What the content shows of the masks: blended like colors, rounded down to 1/2048, and the first takes the rest.
  Imath::V4f weights_of(const Content& content, V2i c, V2i d) const {
    Imath::V4f weights(0);
    if (tile_.masks.empty()) return weights;
    weights[0] = 1;
    for (size_t k = 1; k < tile_.masks.size(); ++k) {
      const double weight = std::floor(content_weight(tile_.masks[k], content, c, d) * 2048) / 2048;
      weights[static_cast<int>(k)] = static_cast<float>(weight);
      weights[0] -= static_cast<float>(weight);
    }
    return weights;
  }

  double content_weight(const Image<float>& mask, const Content& content, V2i c, V2i d) const {
    const double x = (double{1} * content.a * d.x - double{1} * content.b * d.y) / 65536;
    const double y = (double{1} * content.b * d.x + double{1} * content.a * d.y) / 65536;
    const double x256 = std::floor(x * 256 + 0.5), y256 = std::floor(y * 256 + 0.5);
    const int left = static_cast<int>(std::floor(x256 / 256)), top = static_cast<int>(std::floor(y256 / 256));
    const double wx = x256 / 256 - left, wy = y256 / 256 - top;
    const auto at = [&](int i, int j) {
      const V2i p = wrap(c + content.translation + V2i(left + i, top + j), tile_.size());
      return static_cast<double>(mask(p.x, p.y));
    };
    return (at(0, 0) * (1 - wx) + at(1, 0) * wx) * (1 - wy) + (at(0, 1) * (1 - wx) + at(1, 1) * wx) * wy;
  }

 public:
  /// Noises at the texel (x, y) of the infinite texture. Products are exact in double.
  void add_noise(V3f& color, const Imath::V4f& weights, int64_t x, int64_t y) const {
    V3f sum(0);
    for (size_t k = 0; k < tile_.noises.size(); ++k) {
      const auto weight = static_cast<double>(weights[static_cast<int>(k)]);
      const Image<V3f>& noise = tile_.noises[k];
      const V3f& value = noise.data()[noise_number(noise, x, y)];
      for (int channel = 0; channel < 3; ++channel)
        sum[channel] =
            static_cast<float>(static_cast<double>(sum[channel]) + weight * static_cast<double>(value[channel]));
    }
    for (int channel = 0; channel < 3; ++channel) {
      const float n = sum[channel];
      color[channel] += tile_.noise_space == NoiseSpace::root ? n * (twice_root(color[channel]) + n) : n;
    }
  }

  V2i nearest_source(const Content& content, V2i c, int dx, int dy) const {
    const double x = (double{1} * content.a * dx - double{1} * content.b * dy) / 65536;
    const double y = (double{1} * content.b * dx + double{1} * content.a * dy) / 65536;
    const V2i nearest(static_cast<int>(std::floor(x + 0.5)), static_cast<int>(std::floor(y + 0.5)));
    return wrap(c + content.translation + nearest, tile_.size());
  }

  /// A plane of the tile, such as its base, at c + t + M d, blended between texel centers, the place rounded to 1/256
  /// texel.
  V3f content_color(const Image<V3f>& plane, const Content& content, V2i c, int dx, int dy) const {
    const double x = (double{1} * content.a * dx - double{1} * content.b * dy) / 65536;
    const double y = (double{1} * content.b * dx + double{1} * content.a * dy) / 65536;
    const double x256 = std::floor(x * 256 + 0.5), y256 = std::floor(y * 256 + 0.5);
    const int left = static_cast<int>(std::floor(x256 / 256)), top = static_cast<int>(std::floor(y256 / 256));
    const auto at = [&](int i, int j) {
      const V2i p = wrap(c + content.translation + V2i(left + i, top + j), tile_.size());
      return plane(p.x, p.y);
    };
    return blend(at(0, 0), at(1, 0), at(0, 1), at(1, 1), x256 / 256 - left, y256 / 256 - top);
  }

  /// Bilinear interpolation in the order of shaders/README.md, each operation rounded to float.
  static V3f blend(const V3f& ul, const V3f& ur, const V3f& ll, const V3f& lr, double wx, double wy) {
    const auto channel = [&](int c) {
      const auto x = static_cast<float>(wx), y = static_cast<float>(wy);
      const float upper = ul[c] + (ur[c] - ul[c]) * x;
      const float lower = ll[c] + (lr[c] - ll[c]) * x;
      return upper + (lower - upper) * y;
    };
    return {channel(0), channel(1), channel(2)};
  }

 private:
  const SmallTile& tile_;
  uint32_t seed_;
};

}  // namespace texbake
