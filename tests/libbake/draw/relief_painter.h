// Where rays meet the relief of a stack's coarsest scale, and the light there: by definition, in double, on painted
// heights and normals. For rays that reach level 0 alone.
#pragma once

#include "stack_painter.h"

namespace texbake {

/// Heights and normals of the coarsest tile, +y up, and how they are seen.
struct SmallRelief {
  Image<float> height;
  Image<V3f> normal;
  int depth_px = 0;  ///< texels of the coarsest scale between height 0 and 1
  int steps = 1, refinements = 0;
  double light_x = 0, light_y = 0, ambient = 0;

  double most() const { return double{*std::max_element(height.begin(), height.end())}; }
  double least() const { return double{*std::min_element(height.begin(), height.end())}; }
  double mean() const {
    double sum = 0;
    for (const float h : height) sum += double{h};
    return sum / static_cast<double>(height.size());
  }
};

class ReliefPainter {
 public:
  /// Contents of the coarsest scale are moved, not turned.
  ReliefPainter(const SmallStack& stack, const SmallRelief& relief, uint32_t seed)
      : stack_(stack),
        relief_(relief),
        heights_(painted(stack.tiles.front().tile, relief.height)),
        normals_(painted(stack.tiles.front().tile, relief.normal)),
        coarse_seed_(static_cast<uint32_t>(uint64_t{seed} + (stack.tiles.size() - 1) * 2654435769)) {}

  struct Met {
    int64_t x_256, y_256;  ///< of the finest scale, from the infinite texture's origin
    int light_4096;
  };

  /// The ray goes `way` texels to the right and down for each that it falls, by at least half of `steps` texels in all.
  Met met(int64_t x_256, int64_t y_256, Imath::V2d way) const {
    int64_t x = x_256, y = y_256, finer = 1;
    for (auto transfer = stack_.transfers.rbegin(); std::next(transfer) != stack_.transfers.rend(); ++transfer) {
      x = Painter::floor_div(x, transfer->ratio);
      y = Painter::floor_div(y, transfer->ratio);
      finer *= transfer->ratio;
    }
    const Imath::V2d slope = way * relief_.depth_px;
    const double plane = relief_.mean();
    const auto is_below = [&](double level) {
      const Imath::V2d moved = slope * (plane - level);
      return at(heights_, x + in_256(moved.x), y + in_256(moved.y)).x >= level;
    };
    double above = relief_.most();
    const double stride = (relief_.most() - relief_.least()) / relief_.steps;
    int step = 1;
    while (step < relief_.steps && !is_below(relief_.most() - stride * step)) ++step;
    above = relief_.most() - stride * (step - 1);
    double below = relief_.most() - stride * step;
    for (int i = 0; i < relief_.refinements; ++i) {
      const double middle = (above + below) / 2;
      (is_below(middle) ? below : above) = middle;
    }
    const Imath::V2d moved = slope * (plane - below);
    const Imath::V3d normal = at(normals_, x + in_256(moved.x), y + in_256(moved.y));
    const double facing = std::max(0.0, normal.z + normal.x * relief_.light_x - normal.y * relief_.light_y);
    const double light = relief_.ambient + (1 - relief_.ambient) * facing;
    const auto further = static_cast<double>(finer);
    return {x_256 + in_256(moved.x * further), y_256 + in_256(moved.y * further),
            static_cast<int>(std::floor(light * 4096 + 0.5))};
  }

 private:
  static int64_t in_256(double texels) { return static_cast<int64_t>(std::floor(texels * 256 + 0.5)); }

  template <class T>
  static SmallTile painted(const SmallTile& tile, const Image<T>& plane) {
    const Partition& p = tile.patches.partition;
    SmallTile copy{Image<V3f>(plane.width(), plane.height()),
                   {{p.idx.clone(), p.owner.clone(), p.centers, p.areas_px}},
                   tile.contents};
    for (size_t i = 0; i < plane.size(); ++i) copy.base.data()[i] = V3f(plane.data()[i]);
    return copy;
  }

  /// Between four texels; their values are short enough for the products to be exact.
  Imath::V3d at(const SmallTile& tile, int64_t x_256, int64_t y_256) const {
    const int64_t left = Painter::floor_div(x_256 - 128, 256), top = Painter::floor_div(y_256 - 128, 256);
    const double wx = static_cast<double>(x_256 - 128 - left * 256) / 256;
    const double wy = static_cast<double>(y_256 - 128 - top * 256) / 256;
    const Painting near = Painter(tile, coarse_seed_).paint(left, top, 2, 2);
    const auto texel = [&](int i, int j) { return Imath::V3d(near.color(i, j)); };
    return (texel(0, 0) * (1 - wx) + texel(1, 0) * wx) * (1 - wy) + (texel(0, 1) * (1 - wx) + texel(1, 1) * wx) * wy;
  }

  const SmallStack& stack_;
  const SmallRelief& relief_;
  SmallTile heights_, normals_;
  uint32_t coarse_seed_;
};

}  // namespace texbake
