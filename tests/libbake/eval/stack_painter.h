// The slow painter of two scales: paints each forward by itself, and adds the coarse colour at the centre of each fine
// fragment (CE13, eq. 5). For contents that are moved, not turned, and colours that are passed by fragment.
#pragma once

#include "painter.h"
#include "small_stack.h"

namespace texbake {

class StackPainter {
 public:
  /// `stack` has two scales and no gains of detail. Scale 0 draws with a seed of its own.
  StackPainter(const SmallStack& stack, uint32_t seed)
      : coarse_(stack.tiles.front()),
        fine_(stack.tiles.back()),
        transfer_(stack.transfers.back()),
        coarse_painter_(coarse_.tile, static_cast<uint32_t>(uint64_t{seed} + 2654435769)),
        fine_painter_(fine_.tile, seed),
        fine_mean_(mean_of(fine_.tile.base)) {}

  const Painter& fine() const { return fine_painter_; }

  /// What the coarse scale shows at a texel of its own.
  V3f coarse_texel(int64_t x, int64_t y) const { return coarse_painter_.paint(x, y, 1, 1).color(0, 0); }

  /// What the fine scale shows at one: its own colour, less its mean, and the coarse colour where the fragment's centre
  /// lies, as far as the one takes and the other gives it.
  V3f fine_texel(int64_t x, int64_t y) const {
    const Painting own = fine_painter_.paint(x, y, 1, 1);
    const V2i source = own.source(0, 0);
    const Partition& fragments = fine_.fragments.partition;
    const uint32_t fragment = fragments.idx(source.x, source.y);
    const OwnerOffset owner = fragments.owner(source.x, source.y);
    const V2i n = fine_.tile.size();
    const V2i way = fragments.centers[fragment] + V2i(owner.x * n.x, owner.y * n.y) - source;
    const Painting outer = coarse_painter_.paint(Painter::floor_div(x + way.x, transfer_.ratio),
                                                 Painter::floor_div(y + way.y, transfer_.ratio), 1, 1);
    const uint32_t taking = fine_.fragments.fragments[fragment].class_idx;
    const uint32_t giving = coarse_.colors.index(outer.source(0, 0).x, outer.source(0, 0).y);
    const float share = transfer_.weights[taking] * transfer_.coarse_weights[giving];
    return own.color(0, 0) + (outer.color(0, 0) - fine_mean_) * share;
  }

  V3f fine_bilinear(int64_t x_256, int64_t y_256) const {
    return bilinear(x_256, y_256, [&](int64_t x, int64_t y) { return fine_texel(x, y); });
  }

  /// The fine scale, faded into the coarse one at the same point, in 1/256 of its texels rounded down.
  V3f faded(int64_t x_256, int64_t y_256, float fading) const {
    const V3f near = fine_bilinear(x_256, y_256);
    const V3f far = bilinear(Painter::floor_div(x_256, transfer_.ratio), Painter::floor_div(y_256, transfer_.ratio),
                             [&](int64_t x, int64_t y) { return coarse_texel(x, y); });
    return fading == 1 ? far : near + (far - near) * fading;
  }

 private:
  template <class Texel>
  static V3f bilinear(int64_t x_256, int64_t y_256, const Texel& texel) {
    const int64_t left = Painter::floor_div(x_256 - 128, 256), top = Painter::floor_div(y_256 - 128, 256);
    const double wx = static_cast<double>(x_256 - 128 - left * 256) / 256;
    const double wy = static_cast<double>(y_256 - 128 - top * 256) / 256;
    return Painter::blend(texel(left, top), texel(left + 1, top), texel(left, top + 1), texel(left + 1, top + 1), wx,
                          wy);
  }

  /// Sums of halves are exact in double.
  static V3f mean_of(const Image<V3f>& base) {
    Imath::V3d sum(0);
    for (const V3f& color : base) sum += Imath::V3d(color);
    return V3f(sum / static_cast<double>(base.size()));
  }

  const ScaleTile& coarse_;
  const ScaleTile& fine_;
  const ScaleTransfer& transfer_;
  Painter coarse_painter_, fine_painter_;
  V3f fine_mean_;
};

}  // namespace texbake
