#include "formats/picture_bytes.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "formats/srgb_codes.h"
#include "libbake/base/error.h"

namespace texbake {

std::string picture_bytes(ImageView<const V3f> linear, PictureCoding coding) {
  const SrgbEncoder encode(8);
  std::vector<uint8_t> codes;
  codes.reserve(3 * linear.size());
  for (const V3f& texel : linear)
    for (int channel = 0; channel < 3; ++channel) codes.push_back(static_cast<uint8_t>(encode(texel[channel])));

  const char* const kind = coding == PictureCoding::png ? "png" : "jpeg";
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(kind);
  if (!output) throw Error(ErrorKind::unsupported, fmt::format("this build cannot write {} pictures", kind));
  OIIO::ImageSpec spec(linear.width(), linear.height(), 3, OIIO::TypeDesc::UINT8);
  spec.attribute("DateTime", "");
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("compression", coding == PictureCoding::png ? "zip" : "jpeg:88");
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  output->set_ioproxy(&memory);
  if (!output->open(std::string("picture.") + kind, spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, codes.data()) || !output->close())
    throw Error(ErrorKind::unsupported, fmt::format("a picture could not be encoded: {}", output->geterror()));
  return {bytes.begin(), bytes.end()};
}

}  // namespace texbake
