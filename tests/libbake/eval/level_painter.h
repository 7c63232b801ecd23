// Levels of detail by definition, from painted texels: slow, and shares no line with the evaluator.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "painter.h"

namespace texbake {

class LevelPainter {
  using V4f = Imath::V4f;

 public:
  /// `noise_gain`: what the noise of each texel of the tile is multiplied with; empty: 1.
  LevelPainter(const SmallTile& tile, uint32_t seed, Image<float> noise_gain = {})
      : tile_(tile), painter_(tile, seed), noise_gain_(std::move(noise_gain)) {}

  /// The point in 1/256 texel from the infinite texture's origin, between two levels, level_256 / 256 being at most the
  /// tile's last.
  V3f trilinear(int64_t x_256, int64_t y_256, int level_256) const {
    const int level = level_256 / 256;
    const V3f finer = bilinear(x_256, y_256, level);
    if (level_256 % 256 == 0) return finer;
    const V3f coarser = bilinear(x_256, y_256, level + 1);
    const float w = static_cast<float>(level_256 % 256) / 256;
    V3f blended;
    for (int c = 0; c < 3; ++c) blended[c] = finer[c] + (coarser[c] - finer[c]) * w;
    return blended;
  }

  /// Block (x, y), counted from the infinite texture's origin.
  V3f block(int64_t x, int64_t y, int level) const {
    const int side = 1 << level;
    const Painting painting = painter_.paint(x * side, y * side, side, side);
    if (level == 0) return painting.color(0, 0);
    V3f sum(0);
    int steps[4] = {0, 0, 0, 0};  // of weights, in 1/2048
    for (const Shape& shape : shapes(painting, {0, 0}, side, {})) {
      const auto structure = [&](V2i p) { return V4f(painting.structure(p.x, p.y)); };
      const V4f shown = share(painting, shape, {0, 0}, side, structure);
      const V4f weights = share(painting, shape, {0, 0}, side, [&](V2i p) { return gained(painting, p); });
      V3f value(shown.x, shown.y, shown.z);
      for (size_t k = 0; k < tile_.noises.size(); ++k) {
        const float weight = weights[static_cast<int>(k)];
        for (int c = 0; c < 3; ++c) value[c] += static_cast<float>(noise_mean(k, c)) * weight;
        steps[k] += static_cast<int>(std::lround(weight * 2048));
      }
      sum += value;
    }
    for (size_t k = 0; k < tile_.noises.size(); ++k)
      for (int c = 0; c < 3; ++c) sum[c] += grain(k, c, x, y, side) * (static_cast<float>(steps[k]) / 2048);
    return sum;
  }

  /// The sum of what the patches under a square of side² texels show there, each averaged over it.
  V3f shares(int64_t x, int64_t y, int side) const {
    const Painting painting = painter_.paint(x * side, y * side, side, side);
    V3f sum(0);
    for (const Shape& shape : shapes(painting, {0, 0}, side, {})) {
      const V4f shown = share(painting, shape, {0, 0}, side, [&](V2i p) { return V4f(painting.structure(p.x, p.y)); });
      sum += V3f(shown.x, shown.y, shown.z);
    }
    return sum;
  }

  /// The texels of each of them, from the square's corner, in the order in which its quarters bring them.
  std::vector<std::vector<V2i>> patches_of(int64_t x, int64_t y, int side) const {
    const Painting painting = painter_.paint(x * side, y * side, side, side);
    std::vector<std::vector<V2i>> patches;
    for (const Shape& shape : shapes(painting, {0, 0}, side, {}))
      add_texels(painting, shape, {0, 0}, side, patches.emplace_back());
    return patches;
  }

 private:
  /// A patch, and in which repetition from the block's own its centre lies.
  struct Shape {
    uint32_t patch;
    OwnerOffset owner;
    bool operator==(const Shape&) const = default;
  };

  Shape shape_at(const Painting& painting, V2i p) const {
    const Partition& partition = tile_.patches.partition;
    const V2i n = tile_.size();
    const int64_t x = painting.x0 + p.x, y = painting.y0 + p.y;
    const V2i at(static_cast<int>(x - Painter::floor_div(x, n.x) * n.x),
                 static_cast<int>(y - Painter::floor_div(y, n.y) * n.y));
    return {partition.idx(at.x, at.y), partition.owner(at.x, at.y)};
  }

  static constexpr V2i quarter(V2i p, int half, int i) { return {p.x + half * (i % 2), p.y + half * (i / 2)}; }

  /// Those under a square, each once, as its quarters bring them.
  std::vector<Shape> shapes(const Painting& painting, V2i p, int side, std::vector<Shape> known) const {
    if (side > 1) {
      for (int i = 0; i < 4; ++i) known = shapes(painting, quarter(p, side / 2, i), side / 2, std::move(known));
      return known;
    }
    const Shape shape = shape_at(painting, p);
    if (std::find(known.begin(), known.end(), shape) == known.end()) known.push_back(shape);
    return known;
  }

  void add_texels(const Painting& painting, const Shape& shape, V2i p, int side, std::vector<V2i>& texels) const {
    if (side == 1 && shape_at(painting, p) == shape) texels.push_back(p);
    for (int i = 0; side > 1 && i < 4; ++i) add_texels(painting, shape, quarter(p, side / 2, i), side / 2, texels);
  }

  template <class At>
  V4f share(const Painting& painting, const Shape& shape, V2i p, int side, const At& at) const {
    if (side == 1) return shape_at(painting, p) == shape ? at(p) : V4f(0);
    Imath::V4d sum(0);
    for (int i = 0; i < 4; ++i) sum += Imath::V4d(share(painting, shape, quarter(p, side / 2, i), side / 2, at));
    return V4f(sum / 4.0);
  }

  V4f gained(const Painting& painting, V2i p) const {
    const V2i source = painting.source(p.x, p.y);
    return painting.weights(p.x, p.y) * (noise_gain_.empty() ? 1 : noise_gain_(source.x, source.y));
  }

  double noise_mean(size_t k, int channel) const {
    double sum = 0;
    for (const V3f& c : tile_.noises[k]) sum += double{c[channel]};
    return sum / static_cast<double>(tile_.noises[k].size());
  }

  /// What noise k has in a square beside its mean, rounded to half.
  float grain(size_t k, int channel, int64_t x, int64_t y, int side) const {
    const Image<V3f>& noise = tile_.noises[k];
    if (side > noise.width()) return 0;
    double sum = 0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        sum += double{noise.data()[painter_.noise_number(noise, x * side + i, y * side + j)][channel]};
    return half_exact(static_cast<float>(sum / side / side - noise_mean(k, channel)));
  }

  V3f bilinear(int64_t x_256, int64_t y_256, int level) const {
    const int64_t side_256 = int64_t{256} << level;
    const int64_t u = x_256 - side_256 / 2, v = y_256 - side_256 / 2;
    const int64_t x = Painter::floor_div(u, side_256), y = Painter::floor_div(v, side_256);
    const auto weight = [&](int64_t rest) { return static_cast<double>(rest * 256 / side_256) / 256; };
    return Painter::blend(block(x, y, level), block(x + 1, y, level), block(x, y + 1, level),
                          block(x + 1, y + 1, level), weight(u - x * side_256), weight(v - y * side_256));
  }

  const SmallTile& tile_;
  Painter painter_;
  Image<float> noise_gain_;
};

}  // namespace texbake
