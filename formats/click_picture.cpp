#include "formats/click_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "formats/limits.h"
#include "formats/picture_input.h"

namespace texbake {
namespace {

Error refusal(const std::string& path, const std::string& found) {
  return Error(
      ErrorKind::bad_data,
      fmt::format("{}: expected clicks as .json, .csv or a gray picture whose alpha marks where they are, found {}",
                  path, found));
}

struct Pixels {
  std::vector<float> values;  ///< channels interleaved
  int width = 0, height = 0, channels = 0;
  int alpha = -1;  ///< the channel; −1: none
};

Pixels read_pixels(const std::string& path) {
  const std::unique_ptr<PictureInput> open = open_picture_input(path);
  const OIIO::ImageSpec& spec = open->spec;
  if (spec.width < 1 || spec.height < 1 || spec.width > kMaxTileSize || spec.height > kMaxTileSize || spec.deep)
    throw refusal(path, fmt::format("{} x {} texels", spec.width, spec.height));
  const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
  Pixels pixels{{}, spec.width, spec.height, spec.nchannels};
  if (alpha != spec.channelnames.end()) pixels.alpha = static_cast<int>(alpha - spec.channelnames.begin());
  const int colors = pixels.channels - (pixels.alpha >= 0 ? 1 : 0);
  if (colors != 1 && colors != 3) throw refusal(path, fmt::format("{} channels", pixels.channels));
  pixels.values.resize(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                       static_cast<size_t>(pixels.channels));
  if (!open->input->read_image(0, 0, 0, pixels.channels, OIIO::TypeDesc::FLOAT, pixels.values.data()))
    throw refusal(path, "a damaged picture (" + open->input->geterror() + ")");
  return pixels;
}

}  // namespace

ClickFile read_click_picture(const std::string& path) {
  const Pixels pixels = read_pixels(path);
  ClickFile file;
  file.picture_size = V2i(pixels.width, pixels.height);
  const float* texel = pixels.values.data();
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x, texel += pixels.channels) {
      const float height = texel[pixels.alpha == 0 ? 1 : 0];
      for (int c = 0; c < pixels.channels; ++c)
        if (c != pixels.alpha && texel[c] != height && !std::isnan(height))
          throw refusal(path, fmt::format("color at texel ({}, {})", x, y));
      const bool is_click = pixels.alpha >= 0 ? texel[pixels.alpha] > 0 : height != 0;
      if (is_click) file.clicks.push_back({{x, y}, height});
    }
  return file;
}

}  // namespace texbake
