#include "cli/view_options.h"

namespace texbake {

void check_view(const ViewOptions& options, const WindowOptions& window) {
  const auto refuse = [](const char* what) { throw Error(ErrorKind::usage, what); };
  const ViewOptions standard;
  const bool has_camera = options.camera_height_texels != standard.camera_height_texels ||
                          options.pitch_deg != standard.pitch_deg || options.yaw_deg != standard.yaw_deg ||
                          options.fov_deg != standard.fov_deg;
  if (options.view == View::flat && has_camera)
    refuse("--camera-height, --pitch, --yaw, --fov: a flat window has no camera; expected --view plane beside them");
  if (options.view == View::plane && window.step_texels != WindowOptions().step_texels)
    refuse("--step: does not apply to a plane in perspective; use --camera-height");
}

Perspective perspective_of(const ViewOptions& options, const WindowOptions& window, PixelSize size, V2i tile_size) {
  const DecimalPoint origin = parse_point("origin", window.origin);
  Perspective view;
  view.origin_x = tile_offset(origin.x, tile_size.x, "origin");
  view.origin_y = tile_offset(origin.y, tile_size.y, "origin");
  view.height_texels = options.camera_height_texels;
  view.pitch_deg = options.pitch_deg;
  view.yaw_deg = options.yaw_deg;
  view.fov_deg = options.fov_deg;
  view.width = size.width;
  view.height = size.height;
  view.seed = window.seed;
  view.filter = window.filter;
  check_perspective(view, tile_size);
  return view;
}

}  // namespace texbake
