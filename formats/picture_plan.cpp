#include "formats/picture_plan.h"

#include <fmt/format.h>

#include "formats/color_facts.h"
#include "libbake/base/error.h"

namespace texbake {
namespace {

void check_size(const std::string& path, const OIIO::ImageSpec& spec) {
  if (spec.width < 1 || spec.height < 1)
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: expected at least 1 x 1 texels, found {} x {}", path, spec.width, spec.height));
  if (spec.width > kMaxPictureSide || spec.height > kMaxPictureSide)
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: expected at most {} texels on a side, found {} x {}; crop it or scale it down", path,
                            kMaxPictureSide, spec.width, spec.height));
  if (spec.deep || spec.depth > 1)
    throw Error(ErrorKind::unsupported, fmt::format("{}: expected a flat picture, found a {} one; flatten it", path,
                                                    spec.deep ? "deep" : "volume"));
}

[[noreturn]] void throw_unsupported(const std::string& path, const char* found) {
  throw Error(ErrorKind::unsupported,
              fmt::format("{}: expected a gray or RGB image, found {}, which is not supported; export it as PNG or "
                          "OpenEXR",
                          path, found));
}

// Kinds of TIFF whose numbers OpenImageIO hands out wrongly, or that are no picture (TIFF 6.0, DNG 1.6).
void check_tiff(const std::string& path, const OIIO::ImageSpec& spec) {
  if (spec.get_int_attribute("tiff:subfiletype") & 1) throw_unsupported(path, "only a preview, as in raw files");
  switch (spec.get_int_attribute("tiff:PhotometricInterpretation", 1)) {
    case 0:
      if (spec.nchannels > 1) throw_unsupported(path, "a negative (white is 0) with alpha");
      break;
    case 8:
    case 9:
    case 10:
      throw_unsupported(path, "CIELAB colors");
    case 32803:
    case 34892:
      throw_unsupported(path, "the raw data of a camera");
    case 32844:
    case 32845:
      throw_unsupported(path, "LogLuv colors");
    default:
      break;
  }
  if (spec.format == OIIO::TypeDesc::DOUBLE && (spec.tile_width > 0 || spec.height == 1))
    throw_unsupported(path, "64-bit floats in tiles or in a single row");
}

// Only where the format says so, or where OpenImageIO's reader multiplies.
bool is_premultiplied(const PictureInput& open) {
  const OIIO::ImageSpec& spec = open.spec;
  constexpr int kTargaPremultiplied = 4;  // TGA 2.0, field 24
  const std::string compression = spec.get_string_attribute("compression");
  switch (open.format) {
    case FileFormat::openexr:
    case FileFormat::webp:
      return true;
    case FileFormat::tiff:
      return spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    case FileFormat::targa:
      return spec.get_int_attribute("tga:alpha_type") == kTargaPremultiplied;
    case FileFormat::dds:
      return compression == "DXT2" || compression == "DXT4";
    default:
      return false;
  }
}

bool has_inks(const PictureInput& open) {
  return open.format == FileFormat::tiff && open.spec.get_int_attribute("tiff:PhotometricInterpretation") == 5;
}

// OpenImageIO turns negatives of 8 bits around, and no others.
bool is_left_negative(const PictureInput& open) {
  return open.format == FileFormat::tiff && open.spec.format != OIIO::TypeDesc::UINT8 &&
         open.spec.get_int_attribute("tiff:PhotometricInterpretation", 1) == 0;
}

// The part of the file that has the layer that was asked for: by its own name, or by that of its channels.
void find_layer(PictureInput& open, std::string& layer) {
  if (layer.empty() || has_layer(open.spec.channelnames, layer)) return;
  for (int part = 0; select_part(open, part); ++part) {
    if (OIIO::Strutil::iequals(open.spec.get_string_attribute("name"), layer)) {
      layer.clear();
      return;
    }
    if (has_layer(open.spec.channelnames, layer)) return;
  }
  select_part(open, 0);
}

ChannelChoice channels_of(const PictureInput& open, PictureRole role, const std::string& layer) {
  if (!has_inks(open)) return choose_channels(open.path, open.spec.channelnames, role, layer);
  if (role != PictureRole::color || open.spec.nchannels < 4) throw_unsupported(open.path, "inks");
  return {.color = {0, 1, 2, 3}};
}

ColorReading color_of(const PictureInput& open, const PictureRequest& request, const PngCheck& png, int channels) {
  const bool is_float = open.spec.format.is_floating_point();
  const InputCurve usual = is_float ? InputCurve::linear() : InputCurve::srgb();
  if (request.role != PictureRole::color) return {};
  ColorFacts facts = color_facts(open, png);
  if (request.values == PictureValues::kept) {  // a frame is compared by its numbers: no primaries are exchanged
    facts.profile.clear();
    facts.primaries.reset();
  }
  return color_reading(open.path, facts, request.space, channels, usual);
}

}  // namespace

PicturePlan plan_picture(PictureInput& open, const PictureRequest& request, const PngCheck& png) {
  std::string layer = request.layer;
  find_layer(open, layer);
  check_size(open.path, open.spec);
  if (open.format == FileFormat::tiff) check_tiff(open.path, open.spec);
  if (open.format == FileFormat::jpeg && open.spec.get_string_attribute("jpeg:ColorSpace") == "CMYK")
    throw_unsupported(open.path, "CMYK inks");

  PicturePlan plan;
  plan.channels = channels_of(open, request.role, layer);
  plan.is_premultiplied =
      plan.channels.alpha >= 0 && request.values == PictureValues::checked && is_premultiplied(open);
  plan.is_negative = is_left_negative(open);
  plan.color = color_of(open, request, png, static_cast<int>(plan.channels.color.size()));
  plan.orientation = open.spec.get_int_attribute("Orientation", 1);
  if (plan.orientation < 1 || plan.orientation > 8) plan.orientation = 1;
  if (request.role == PictureRole::normal && plan.orientation != 1)
    throw Error(ErrorKind::unsupported, fmt::format("{}: expected an upright normal map, found EXIF orientation {}; "
                                                    "its vectors would have to rotate too: export it upright",
                                                    open.path, plan.orientation));
  return plan;
}

}  // namespace texbake
