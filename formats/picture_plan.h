// Decides how the texels of an opened file become a picture, before they are read.
#pragma once

#include "formats/picture.h"
#include "formats/picture_channels.h"
#include "formats/picture_color.h"
#include "formats/picture_input.h"
#include "formats/png_check.h"

namespace texbake {

struct PicturePlan {
  ChannelChoice channels = {};
  bool is_premultiplied = false;  ///< color is divided by alpha
  bool is_negative = false;       ///< the highest number is black
  ColorReading color = {};
  int orientation = 1;  ///< EXIF, 1 … 8
};

/// Goes on to the part of the file that has the layer that `request` asks for. `png` counts for PNG alone. Throws Error
/// as read_picture does.
PicturePlan plan_picture(PictureInput& open, const PictureRequest& request, const PngCheck& png);

}  // namespace texbake
