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
  /// `noise_gain`: what the noise of each texel of the tile is multiplied with; empty: 1. `structure`: the tile to
  /// whose light the noise belongs, where `tile` has another base.
  LevelPainter(const SmallTile& tile, uint32_t seed, Image<float> noise_gain = {}, const SmallTile* structure = nullptr)
      : tile_(tile), painter_(tile, seed), noise_gain_(std::move(noise_gain)) {
    const SmallTile& noisy = structure ? *structure : tile;
    for (size_t k = 0; k < noisy.noises.size(); ++k)
      for (int c = 0; c < 3; ++c) {
        const auto value = [&](size_t l, size_t i) { return double{noisy.noises[l].data()[i][c]}; };
        const auto mean = [&](const auto& of) {
          double sum = 0;
          for (size_t i = 0; i < noisy.noises[k].size(); ++i) sum += of(i);
          return sum / static_cast<double>(noisy.noises[k].size());
        };
        means_[k][c] = mean([&](size_t i) { return value(k, i); });
        for (size_t l = 0; l < noisy.noises.size(); ++l)
          products_[k][l][c] = mean([&](size_t i) { return value(k, i) * value(l, i); });
      }
    noises_ = noisy.noises.size();
    for (size_t k = 0; k < noises_; ++k)
      for (int c = 0; c < 3; ++c) root_share_[k][c] = root_share(noisy, k, c);
  }

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
      const V4f shown = share(painting, shape, {0, 0}, side, [&](V2i p) { return V4f(with_mean_noise(painting, p)); });
      const V4f weights = share(painting, shape, {0, 0}, side, [&](V2i p) { return gained(painting, p); });
      sum += V3f(shown.x, shown.y, shown.z);
      for (size_t k = 0; k < tile_.noises.size(); ++k)
        steps[k] += static_cast<int>(std::lround(weights[static_cast<int>(k)] * 2048));
    }
    for (int c = 0; c < 3; ++c) {
      float grain = 0, squares = 0;
      for (size_t k = 0; k < tile_.noises.size(); ++k) {
        const float weight = static_cast<float>(steps[k]) / 2048;
        const double scale = is_root() ? root_share_[k][c] : 1;
        grain += rest(k, x, y, side, [&](const V3f& n) { return double{n[c]} * scale; }) * weight;
        squares += rest(k, x, y, side, [&](const V3f& n) { return double{n[c]} * double{n[c]}; }) * weight;
      }
      sum[c] += is_root() ? grain * Painter::twice_root(sum[c]) + squares : grain;
    }
    return sum;
  }

  /// What noise adds to `light` on the average, in double.
  double mean_change(double light, int channel, const Imath::V4f& weights) const {
    double sum = 0;
    double square = 0;
    for (size_t k = 0; k < noises_; ++k) {
      const auto w = double{weights[static_cast<int>(k)]};
      if (w == 0) continue;
      sum += means_[k][channel] * w;
      for (size_t l = 0; l < noises_; ++l)
        square += products_[k][l][channel] * (w * double{weights[static_cast<int>(l)]});
    }
    return is_root() ? std::sqrt(std::max(light, 0.0)) * sum * 2 + square : sum;
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
  /// A patch, and in which repetition from the block's own its center lies.
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

  float gain(const Painting& painting, V2i p) const {
    const V2i source = painting.source(p.x, p.y);
    return noise_gain_.empty() ? 1 : noise_gain_(source.x, source.y);
  }
  V4f gained(const Painting& painting, V2i p) const { return painting.weights(p.x, p.y) * gain(painting, p); }

  bool is_root() const { return tile_.noise_space == NoiseSpace::root; }

  V3f with_mean_noise(const Painting& painting, V2i p) const {
    V3f light = painting.structure(p.x, p.y);
    for (int c = 0; c < 3; ++c) {
      const double change = mean_change(static_cast<double>(light[c]), c, painting.weights(p.x, p.y));
      light[c] += static_cast<float>(change * static_cast<double>(gain(painting, p)));
    }
    return light;
  }

  /// Σ √s / Σ √(s + change) of noise k over the tile, by its mask.
  double root_share(const SmallTile& tile, size_t k, int channel) const {
    double part = 0;
    double whole = 0;
    Imath::V4f alone(0);
    alone[static_cast<int>(k)] = 1;
    for (size_t i = 0; i < tile.base.size(); ++i) {
      const double weight = double{tile.masks[k].data()[i]} * 2048;
      const auto light = double{tile.base.data()[i][channel]};
      if (weight == 0) continue;
      part += std::sqrt(light) * weight;
      whole += std::sqrt(light + mean_change(light, channel, alone)) * weight;
    }
    return whole > 0 ? part / whole : 1;
  }

  /// What a function of noise k has in a square beside its mean, rounded to half.
  template <class Of>
  float rest(size_t k, int64_t x, int64_t y, int side, const Of& of) const {
    const Image<V3f>& noise = tile_.noises[k];
    if (side > noise.width()) return 0;
    double sum = 0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) sum += of(noise.data()[painter_.noise_number(noise, x * side + i, y * side + j)]);
    double mean = 0;
    for (const V3f& value : noise) mean += of(value);
    return half_exact(static_cast<float>(sum / side / side - mean / static_cast<double>(noise.size())));
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
  size_t noises_ = 0;
  double means_[4][3] = {}, products_[4][4][3] = {}, root_share_[4][3] = {};
};

}  // namespace texbake
