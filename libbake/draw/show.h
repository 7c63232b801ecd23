// Views of how the infinite texture is put together, for the artist's eye.
#pragma once

#include "libbake/draw/window.h"
#include "libbake/planes/evaluator_input.h"
#include "libbake/planes/evaluator_planes.h"

namespace texbake {

enum class Show {
  color,      ///< what the texture is
  patches,    ///< one hue for each patch of the tile, borders dark
  fragments,  ///< one hue for each fragment, where its content comes from
  contents,   ///< one color for each content, gray for the identity; patch borders dark
  index,      ///< the dominant color of each texel's class
  variation,  ///< v as gray, middle gray where it is 0
  structure,  ///< the texture without its noise
  noise,      ///< the noise alone, about middle gray
  masks,      ///< where each noise lives: a blend of one hue for each
};
template <>
struct EnumNames<Show> {
  static constexpr std::pair<Show, std::string_view> values[] = {
      {Show::color, "color"},         {Show::patches, "patches"}, {Show::fragments, "fragments"},
      {Show::contents, "contents"},   {Show::index, "index"},     {Show::variation, "variation"},
      {Show::structure, "structure"}, {Show::noise, "noise"},     {Show::masks, "masks"}};
};

/// Throws Error(usage) when what the planes are made of lacks what is to be shown.
void check_show(const EvaluatorInput& input, Show show);

/// Rows of the window in linear Rec.709. All views but `color` show the nearest texel, whatever the filter. What
/// check_show refuses is expected not to be asked for.
Image<V3f> show_rows(const EvaluatorPlanes& planes, const Window& window, Show show, int row_begin, int row_end);

}  // namespace texbake
