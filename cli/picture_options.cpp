#include "cli/picture_options.h"

namespace texbake {

void check_picture(const PictureOptions& options, PixelSize size) {
  check_options(options.window);
  check_options(options.view);
  check_options(options.deform);
  check_options(options.relief);
  check_view(options.view, options.window);
  constexpr int kAnySide = 1 << 14;  // of a tile
  Features features = draw_request_of(options, size, {kAnySide, kAnySide}).features();
  // A deformation of a plane is no part of a DrawRequest.
  features.add(Feature::deformation, !deformation_of(options.deform).is_identity());
  check_features(features);
}

DrawRequest draw_request_of(const PictureOptions& options, PixelSize size, V2i tile_size) {
  DrawRequest picture;
  if (options.view.view == View::plane) {
    picture.view = perspective_of(options.view, options.window, size, tile_size);
  } else {
    Window window = window_of(options.window, size, tile_size);
    window.deformation = deformation_of(options.deform);
    picture.view = window;
  }
  picture.map = options.map.value_or("");
  picture.samples = options.view.supersample;
  picture.relief = relief_of(options.relief, options.slant);
  return picture;
}

}  // namespace texbake
