// A drawn surface: color, relief and roughness under one roof, and the light that falls on it.
#pragma once

#include <cstdint>

#include "libbake/base/gaussian.h"
#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

struct Surface {
  Image<V3f> albedo;       ///< linear Rec.709
  Image<float> height;     ///< 0 … 1, where 1 is a tenth of the picture's width
  Image<float> roughness;  ///< 0 … 1
  Wrap border;             ///< repeat: the picture tiles

  Surface(int width, int height_px, Wrap border_rule)
      : albedo(width, height_px), height(width, height_px), roughness(width, height_px, 1.0f), border(border_rule) {}

  V2i size() const { return {albedo.width(), albedo.height()}; }
  /// Position of a texel's center in units of the picture's width.
  V2f place(int x, int y) const {
    const auto unit = static_cast<float>(albedo.width());
    return {(static_cast<float>(x) + 0.5f) / unit, (static_cast<float>(y) + 0.5f) / unit};
  }
};

/// Calls `paint(d, x, y)` for every texel within `radius` of `center`, both in units of the picture's width: d leads
/// from the center to the texel. Wraps where the surface tiles, else leaves out what lies outside.
template <class Paint>
void stamp(const Surface& surface, V2f center, float radius, const Paint& paint) {
  const V2i size = surface.size();
  const auto unit = static_cast<float>(size.x);
  const V2i first(static_cast<int>((center.x - radius) * unit) - 1, static_cast<int>((center.y - radius) * unit) - 1);
  const V2i last(static_cast<int>((center.x + radius) * unit) + 1, static_cast<int>((center.y + radius) * unit) + 1);
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) {
      const V2f d = surface.place(x, y) - center;
      const V2i texel = surface.border == Wrap::repeat ? wrap(V2i(x, y), size) : V2i(x, y);
      const bool inside = texel.x >= 0 && texel.y >= 0 && texel.x < size.x && texel.y < size.y;
      if (inside && d.dot(d) <= radius * radius) paint(d, texel.x, texel.y);
    }
}

/// The surface as a camera sees it from above: warm sunlight from the upper left with shadows, a blue sky, darkness in
/// crevices. Linear Rec.709.
Image<V3f> lit(const Surface& surface);

/// Unit normals, +z toward the viewer, +y up in the picture (the OpenGL convention).
Image<V3f> normals(const Surface& surface);

/// Means of 2×2 texels.
Image<V3f> halved(ImageView<const V3f> image);
Image<float> halved(ImageView<const float> image);

/// Linear Rec.709 of an sRGB color such as 0xb5462e.
V3f color(uint32_t srgb);

inline V3f blend(const V3f& a, const V3f& b, float w) { return a + (b - a) * w; }
/// 0 below `low`, 1 above `high`, smooth between.
float smooth_step(float low, float high, float x);

/// The drawings. `side` is the width in texels; the picture tiles where the name says nothing else.
Surface draw_pebbles(int side, uint32_t seed);
Surface draw_bricks(int side, uint32_t seed);
Surface draw_lichen(int side, uint32_t seed);
/// Does not tile.
Surface draw_leaves(int side, uint32_t seed);

}  // namespace texbake
