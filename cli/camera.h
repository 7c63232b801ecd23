// What an engine's captured frame shows, read from a file: a window, or an endless plane in perspective. The format is
// specified by cli/camera.schema.json.
#pragma once

#include <optional>
#include <string>

#include "cli/picture_options.h"
#include "formats/bundle.h"

namespace texbake {

/// The size of the picture is the frame's.
struct Camera {
  PictureOptions picture;
  std::optional<PixelSize> frame_size;  ///< what the frame must have, where the file says so
};

/// Throws Error(io) when `path` cannot be read, Error(bad_data) for anything but what the schema allows; an unknown
/// member gets a suggestion.
Camera read_camera(const std::string& path);

/// The same from a JSON value; `where` begins the messages.
Camera camera_of(const Json& json, const std::string& where);

}  // namespace texbake
