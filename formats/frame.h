// Reads a frame that an engine captured, as it was stored, so that it can be compared with the reference.
#pragma once

#include <string>
#include <vector>

#include "formats/image_reader.h"
#include "libbake/color/sample_steps.h"

namespace texbake {

struct CapturedFrame {
  Image<V3f> values;  ///< linear light, data or vectors; NaN and infinity as they are stored
  SampleScale scale;  ///< of the file's samples
  std::vector<std::string> notes;
};

/// The first `channels` channels (1 … 3) of a picture of `role`, the others 0; a gray picture has the same in all
/// three. Throws as read_picture does for a file that is no picture, Error(unsupported) for samples other than integers
/// of up to 16 bits by the sRGB curve or none, half, and float.
CapturedFrame read_frame(const std::string& path, PictureRole role, int channels);

/// "8-bit sRGB", "16-bit", "half", "float".
std::string sample_name(const SampleScale& scale);

}  // namespace texbake
