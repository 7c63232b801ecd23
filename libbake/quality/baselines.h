// What a user would pick instead of a bundle, made from the same exemplar: for comparison in the report only.
#pragma once

#include <array>
#include <cstdint>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// The exemplar again and again, from its own origin. `width_px`, `height_px` > 0.
Image<V3f> periodic_baseline(ImageView<const V3f> exemplar, int width_px, int height_px);

/// Which texel of the exemplar a Wang tiling shows where.
class WangTiling {
 public:
  /// See wang_baseline.
  WangTiling(ImageView<const V3f> exemplar_luv, V2i tiles, uint32_t seed);
  /// The source of output texel (x, y), 0 ≤ x < tiles.x · width of the exemplar.
  V2i source(int x, int y) const { return sources_[tile_idx_(x / size_.x, y / size_.y)](x % size_.x, y % size_.y); }
  V2i size_px() const { return {tile_idx_.width() * size_.x, tile_idx_.height() * size_.y}; }

 private:
  V2i size_;                            ///< of the exemplar
  Image<uint8_t> tile_idx_;             ///< which of the 16 tiles stands where
  std::array<Image<V2i>, 16> sources_;  ///< of those that are used
};

/// Wang tiles with two colors for each pair of sides: 16 tiles, each the size of the exemplar, whose sides show one of
/// four random places of the exemplar, joined inside the tile along minimum-error cuts.
/// Based on: Cohen et al. 2003, "Wang Tiles for image and texture generation". Gives `tiles` whole tiles; neighbors
/// agree across the border of the picture too.
Image<V3f> wang_baseline(ImageView<const V3f> exemplar, V2i tiles, uint32_t seed);

/// Hexagonal tiling: three weighted readings at randomly shifted places for each texel, with sharpened weights. The
/// hexagon's side is a quarter of the exemplar's. Linear colors in, linear colors out.
/// Based on: Mikkelsen 2022, "Practical Real-Time Hex-Tiling", without rotation. Gives the rows begin … end−1.
Image<V3f> hex_baseline_rows(ImageView<const V3f> exemplar, int width_px, int begin, int end, uint32_t seed);

}  // namespace texbake
