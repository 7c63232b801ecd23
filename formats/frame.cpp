#include "formats/frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "libbake/base/error.h"

namespace texbake {
namespace {

SampleCode integer_code(const Picture& picture, PictureRole role) {
  if (role == PictureRole::normal) return SampleCode::vector;
  return picture.space == "srgb" ? SampleCode::srgb : SampleCode::unit;
}

SampleScale scale_of(const std::string& path, const Picture& picture, PictureRole role) {
  const bool known_curve = picture.space == "srgb" || picture.space == "linear";
  if (picture.is_float && picture.source_bits == 16) return {SampleCode::half, 16};
  if (picture.is_float && picture.source_bits == 32) return {SampleCode::float32, 32};
  if (!picture.is_float && picture.source_bits <= 16 && known_curve)
    return {integer_code(picture, role), picture.source_bits};
  throw Error(ErrorKind::unsupported, fmt::format("{}: expected samples of up to 16 bits in sRGB, or linear half or "
                                                  "float, found {} bits, {}; capture the frame as PNG or EXR",
                                                  path, picture.source_bits, picture.space));
}

Image<V3f> values_of(const Picture& picture, int channels) {
  Image<V3f> values(picture.width(), picture.height());
  for (int c = 0; c < std::min(channels, 3); ++c) {
    const Image<float>& plane = picture.planes[std::min(c, picture.channels - 1)];
    for (size_t i = 0; i < values.size(); ++i) values.data()[i][c] = plane.data()[i];
  }
  return values;
}

}  // namespace

CapturedFrame read_frame(const std::string& path, PictureRole role, int channels) {
  const Picture picture = read_picture({.path = path, .role = role, .values = PictureValues::kept});
  return {values_of(picture, channels), scale_of(path, picture, role), picture.notes};
}

std::string sample_name(const SampleScale& scale) {
  switch (scale.code) {
    case SampleCode::half:
      return "half";
    case SampleCode::float32:
      return "float";
    default:
      return fmt::format("{}-bit{}", scale.bits, scale.code == SampleCode::srgb ? " sRGB" : "");
  }
}

}  // namespace texbake
