// A window of the infinite texture: where it is, and how its pixels are found.
#pragma once

#include "libbake/base/options.h"
#include "libbake/draw/deform.h"
#include "libbake/draw/tile_offset.h"

namespace texbake {

enum class Filter {
  nearest,      ///< the texel in which a pixel's center lies
  bilinear,     ///< between the four texels whose centers surround it
  trilinear,    ///< bilinear between blocks of texels about as large as a pixel: nothing is skipped, far away
  anisotropic,  ///< the same along a pixel's footprint where that is longer than wide; in a window as trilinear
};
template <>
struct EnumNames<Filter> {
  static constexpr std::pair<Filter, std::string_view> values[] = {{Filter::nearest, "nearest"},
                                                                   {Filter::bilinear, "bilinear"},
                                                                   {Filter::trilinear, "trilinear"},
                                                                   {Filter::anisotropic, "anisotropic"}};
};

/// A rectangle of the infinite texture. Pixel (i, j) shows the point origin + (i + ½, j + ½) · step: with a step of 256
/// and a whole origin, pixels are texels.
struct Window {
  TileOffset origin_x;  ///< upper left corner
  TileOffset origin_y;
  uint32_t step_256 = 256;  ///< 1/256 texels to a pixel, ≥ 1
  int width = 0;            ///< pixels
  int height = 0;
  uint32_t seed = 0;  ///< another seed draws other contents, of the same patches
  Filter filter = Filter::bilinear;
  Deformation deformation = {};  ///< of the color; maps have none
};

/// Throws Error(usage) when the window is empty, its origin is outside its tile, or side · step reaches 2^32.
void check_window(const Window& window, V2i tile_size);

/// The level of detail of pixels that are `texels` wide, in 1/256: 256 · log2(texels), rounded, in 0 … 256 (level_count
/// + 1), for trilinear and anisotropic filters; 0 for the others.
int level_256_of(double texels, Filter filter, int level_count);

/// The same of the pixels of a window.
int level_256_of(const Window& window, int level_count);

}  // namespace texbake
