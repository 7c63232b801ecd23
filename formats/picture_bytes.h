// A picture as the bytes of a file, for pages that hold their pictures.
#pragma once

#include <string>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

enum class PictureCoding {
  png,   ///< lossless: drawings
  jpeg,  ///< small: photographs
};

/// `linear` is linear Rec.709, clamped to 0 … 1 and stored by the sRGB curve in 8 bits; not empty. The same picture
/// gives the same bytes.
std::string picture_bytes(ImageView<const V3f> linear, PictureCoding coding);

}  // namespace texbake
