// Draws windows of the infinite texture, by rows, so that pictures of any size fit in bounded memory.
// Based on: Vanhoey et al. 2013, §5.3. The meaning is shaders/README.md; the text that runs is shaders/*.glsl.
#pragma once

#include <string_view>

#include "libbake/base/options.h"
#include "libbake/eval/deform.h"
#include "libbake/eval/prepare.h"

namespace texbake {

enum class Filter {
  nearest,      ///< the texel in which a pixel's centre lies
  bilinear,     ///< between the four texels whose centres surround it
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

/// Where a coordinate lies on one axis: the repetition of the tile, modulo 2^32, and the place there in 1/256 texel.
struct TileOffset {
  uint32_t tile = 0;
  uint32_t offset_256 = 0;  ///< 0 … 256 · tile side − 1
  bool operator==(const TileOffset&) const = default;
};

/// Coordinate `texels` + `fraction_256` / 256 of the infinite texture; any int64 and any fraction.
TileOffset tile_offset(int64_t texels, int64_t fraction_256, int tile_side);

/// The same from a decimal number of texels such as "-1048576.25", rounded to the nearest 1/256 (halves up), any number
/// of digits that fits int64. Throws Error(usage) otherwise; `option` names it in the message.
TileOffset tile_offset(std::string_view decimal_texels, int tile_side, std::string_view option);

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
  Deformation deformation = {};  ///< of the colour; maps have none
};

/// Throws Error(usage) when the window is empty, its origin is outside its tile, or side · step reaches 2^32.
void check_window(const Window& window, V2i tile_size);

/// The level of detail at which a window is drawn, in 1/256: 256 · log2(step / 256) for trilinear and anisotropic
/// filters, rounded, in 0 … 256 (level_count + 1); 0 for the others.
int level_256_of(const Window& window, int level_count);

/// Whether a window is drawn from levels beside level 0: add_levels must come before.
inline bool needs_levels(const Window& window) { return level_256_of(window, 1) > 0; }

/// Rows row_begin ≤ j < row_end of the window: colours of the base, linear Rec.709. The result does not depend on how
/// a window is cut into rows, nor on threads.
Image<V3f> render_rows(const EvaluatorPlanes& planes, const Window& window, int row_begin, int row_end);

/// The same of a map, without deformation, its channels in x, y, z; those that it lacks are 0. Normals turn with their
/// content, are not normalised, and keep their convention; heights shrink with their content.
Image<V3f> render_map_rows(const EvaluatorPlanes& planes, const Plane& map, const Window& window, int row_begin,
                           int row_end);

}  // namespace texbake
