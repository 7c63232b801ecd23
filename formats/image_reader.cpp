#include "formats/image_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>

#include "formats/color_facts.h"
#include "formats/input_file.h"
#include "formats/normal_vectors.h"
#include "formats/picture_channels.h"
#include "formats/picture_color.h"
#include "formats/picture_input.h"
#include "formats/picture_values.h"
#include "formats/png_check.h"
#include "formats/sha256.h"
#include "formats/srgb_codes.h"
#include "libbake/base/half.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr int kRowsRead = 64;  // rows read at a time, at least: a band of the widest picture is 50 MB

// How the texels of an opened file become the picture.
struct PicturePlan {
  ChannelChoice channels;
  bool is_premultiplied = false;
  bool is_negative = false;  // the highest number is black
  ColorReading color;
  int orientation = 1;
};

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
    case PictureFormat::openexr:
    case PictureFormat::webp:
      return true;
    case PictureFormat::tiff:
      return spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    case PictureFormat::targa:
      return spec.get_int_attribute("tga:alpha_type") == kTargaPremultiplied;
    case PictureFormat::dds:
      return compression == "DXT2" || compression == "DXT4";
    default:
      return false;
  }
}

bool has_inks(const PictureInput& open) {
  return open.format == PictureFormat::tiff && open.spec.get_int_attribute("tiff:PhotometricInterpretation") == 5;
}

// OpenImageIO turns negatives of 8 bits around, and no others.
bool is_left_negative(const PictureInput& open) {
  return open.format == PictureFormat::tiff && open.spec.format != OIIO::TypeDesc::UINT8 &&
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

PicturePlan plan_of(PictureInput& open, const PictureRequest& request, const PngCheck& png) {
  std::string layer = request.layer;
  find_layer(open, layer);
  check_size(open.path, open.spec);
  if (open.format == PictureFormat::tiff) check_tiff(open.path, open.spec);
  if (open.format == PictureFormat::jpeg && open.spec.get_string_attribute("jpeg:ColorSpace") == "CMYK")
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

// Integers of 8 and 16 bits are decoded by table, everything else as floats.
bool reads_codes(const PictureInput& open, const PicturePlan& plan) {
  const OIIO::ImageSpec& spec = open.spec;
  return !plan.is_premultiplied && !plan.color.transform && spec.channelformats.empty() &&
         (spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16);
}

// What each code of an integer file means, by one curve.
std::vector<float> code_table(int bits, PictureRole role, const InputCurve& curve, bool is_negative) {
  const int codes = 1 << bits;
  std::vector<float> table(static_cast<size_t>(codes));
  for (int code = 0; code < codes; ++code)
    table[code] = role == PictureRole::normal ? normal_from_code(static_cast<uint16_t>(code), bits)
                                              : curve.decode(static_cast<float>(code) / static_cast<float>(codes - 1));
  if (is_negative) std::reverse(table.begin(), table.end());
  return table;
}

// Rows of a band: whole strips or tiles of the file, for OpenImageIO reads parts of them otherwise, and some wrongly.
int rows_of_band(const PictureInput& open) {
  const OIIO::ImageSpec& spec = open.spec;
  if (spec.tile_width > 0) return spec.tile_height;
  if (open.format != PictureFormat::tiff) return kRowsRead;
  const int strip = spec.get_int_attribute("tiff:RowsPerStrip", 1);
  if (strip < 1 || strip >= spec.height) return spec.height;
  return strip * ((kRowsRead + strip - 1) / strip);
}

// A last band of a single row goes with the one before: OpenImageIO reads it otherwise too.
int end_of_band(int begin, int rows, int height) {
  const int end = height - begin > rows ? begin + rows : height;
  return height - end == 1 ? height : end;
}

// Reads rows begin … end − 1 of the file, all channels below `channel_count`.
template <class Sample>
void read_band(PictureInput& open, int begin, int end, int channel_count, std::vector<Sample>& band) {
  const OIIO::ImageSpec& spec = open.spec;
  band.resize(static_cast<size_t>(spec.width) * static_cast<size_t>(end - begin) * static_cast<size_t>(channel_count));
  const auto type = OIIO::TypeDesc(OIIO::BaseTypeFromC<Sample>::value);
  const bool read = spec.tile_width > 0
                        ? open.input->read_tiles(open.part, 0, spec.x, spec.x + spec.width, spec.y + begin,
                                                 spec.y + end, spec.z, spec.z + 1, 0, channel_count, type, band.data())
                        : open.input->read_scanlines(open.part, 0, spec.y + begin, spec.y + end, spec.z, 0,
                                                     channel_count, type, band.data());

  // Decoders pad what is missing with grey and only warn; stray bytes alone change no texel.
  const std::string words = open.input->geterror();
  const bool harmless = words.find("extraneous bytes") != std::string::npos &&
                        words.find("premature end") == std::string::npos &&
                        words.find("Premature end") == std::string::npos;
  if (!read || (!words.empty() && !harmless)) throw_reader_failure(open.path, words);
}

// Calls `place_row(y, samples)` with every row of the file, in parallel. `prepare` is called once after the first rows
// were read well: a header that lies about the size is found before memory is taken.
template <class Sample, class Prepare, class PlaceRow>
void read_rows(PictureInput& open, const ChannelChoice& channels, const Prepare& prepare, const PlaceRow& place_row) {
  const OIIO::ImageSpec& spec = open.spec;
  const int channel_count =
      1 + std::max(channels.alpha, *std::max_element(channels.color.begin(), channels.color.end()));
  const int rows = rows_of_band(open);
  std::vector<Sample> band;
  for (int begin = 0, end = 0; begin < spec.height; begin = end) {
    end = spec.tile_width > 0 ? std::min(begin + rows, spec.height) : end_of_band(begin, rows, spec.height);
    read_band(open, begin, end, channel_count, band);
    if (begin == 0) prepare();
    parallel_for(begin, end, [&](int y) {
      const size_t row = static_cast<size_t>(y - begin) * static_cast<size_t>(spec.width);
      place_row(y, band.data() + row * static_cast<size_t>(channel_count), channel_count);
    });
  }
}

// Where the texels of the file go.
struct Target {
  Picture& picture;
  V2i stored;
  int orientation;
  std::vector<size_t> transparent;  // in each row of the file: texels that are not opaque

  void put(int x, int y, int channel, float value) {
    const V2i place = upright_place({x, y}, stored, orientation);
    picture.planes[channel](place.x, place.y) = value;
  }
};

// A row of codes, by the table of each channel.
template <class Sample>
void place_codes(const PicturePlan& plan, const std::vector<std::vector<float>>& tables, int y, const Sample* samples,
                 int channel_count, Target& target) {
  const std::vector<int>& color = plan.channels.color;
  const int alpha = plan.channels.alpha;
  for (int x = 0; x < target.stored.x; ++x, samples += channel_count) {
    for (size_t c = 0; c < color.size(); ++c)
      target.put(x, y, static_cast<int>(c), tables[c % tables.size()][samples[color[c]]]);
    if (alpha >= 0 && samples[alpha] != std::numeric_limits<Sample>::max()) ++target.transparent[y];
  }
}

// A row of floats, by the curves.
void place_floats(const PicturePlan& plan, int y, const float* samples, int channel_count, Target& target) {
  const std::vector<int>& color = plan.channels.color;
  const int alpha = plan.channels.alpha;
  for (int x = 0; x < target.stored.x; ++x, samples += channel_count) {
    const float opacity = alpha >= 0 ? samples[alpha] : 1.0f;
    const float divisor = plan.is_premultiplied && opacity > 0 ? opacity : 1.0f;
    for (size_t c = 0; c < color.size(); ++c) {
      const float number = samples[color[c]] / divisor;
      target.put(x, y, static_cast<int>(c),
                 plan.color.curves[c % plan.color.curves.size()].decode(plan.is_negative ? 1 - number : number));
    }
    if (opacity != 1) ++target.transparent[y];
  }
}

// A row of any numbers, through a profile.
void place_transformed(const PicturePlan& plan, int y, const float* samples, int channel_count, Target& target) {
  const std::vector<int>& color = plan.channels.color;
  const auto width = static_cast<size_t>(target.stored.x);
  std::vector<float> encoded(width * color.size()), linear(width * 3);
  for (size_t x = 0; x < width; ++x) {
    const float* const texel = samples + x * static_cast<size_t>(channel_count);
    const float opacity = plan.channels.alpha >= 0 ? texel[plan.channels.alpha] : 1.0f;
    const float divisor = plan.is_premultiplied && opacity > 0 ? opacity : 1.0f;
    for (size_t c = 0; c < color.size(); ++c) {
      const float number = texel[color[c]] / divisor;
      encoded[x * color.size() + c] = plan.is_negative ? 1 - number : number;
    }
    if (opacity != 1) ++target.transparent[y];
  }
  plan.color.transform->apply(encoded.data(), linear.data(), target.stored.x);
  for (int x = 0; x < target.stored.x; ++x)
    for (int c = 0; c < target.picture.channels; ++c) target.put(x, y, c, linear[static_cast<size_t>(3 * x + c)]);
}

template <class Sample>
void read_codes(PictureInput& open, const PicturePlan& plan, PictureRole role, const auto& prepare, Target& target) {
  std::vector<std::vector<float>> tables;
  for (const InputCurve& curve : plan.color.curves)
    tables.push_back(code_table(8 * static_cast<int>(sizeof(Sample)), role, curve, plan.is_negative));
  read_rows<Sample>(open, plan.channels, prepare, [&](int y, const Sample* samples, int channel_count) {
    place_codes(plan, tables, y, samples, channel_count, target);
  });
}

// To Rec.709, where the file has other primaries.
void exchange_primaries(const Imath::M33d& rec709_from_file, Picture& picture) {
  parallel_for(0, picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      Imath::V3d light;
      for (int c = 0; c < 3; ++c) light[c] = static_cast<double>(picture.planes[c](x, y));
      light = light * rec709_from_file;
      for (int c = 0; c < 3; ++c) picture.planes[c](x, y) = static_cast<float>(light[c]);
    }
  });
}

// Decodes every texel into upright planes; returns how many texels are not opaque.
size_t read_planes(PictureInput& open, const PicturePlan& plan, PictureRole role, Picture& picture) {
  const V2i stored(open.spec.width, open.spec.height);
  const V2i upright = upright_size(stored, plan.orientation);
  Target target{picture, stored, plan.orientation, std::vector<size_t>(static_cast<size_t>(stored.y), 0)};
  const auto prepare = [&] {
    for (int c = 0; c < picture.channels; ++c) picture.planes[c] = Image<float>(upright.x, upright.y);
  };

  if (reads_codes(open, plan) && open.spec.format == OIIO::TypeDesc::UINT8) {
    read_codes<uint8_t>(open, plan, role, prepare, target);
  } else if (reads_codes(open, plan)) {
    read_codes<uint16_t>(open, plan, role, prepare, target);
  } else {
    read_rows<float>(open, plan.channels, prepare, [&](int y, const float* samples, int channel_count) {
      if (plan.color.transform)
        place_transformed(plan, y, samples, channel_count, target);
      else
        place_floats(plan, y, samples, channel_count, target);
    });
  }
  if (plan.color.rec709_from_file) exchange_primaries(*plan.color.rec709_from_file, picture);
  return std::accumulate(target.transparent.begin(), target.transparent.end(), size_t{0});
}

std::vector<ImageView<const float>> views(const Picture& picture) {
  return {picture.planes, picture.planes + picture.channels};
}

void note(Picture& picture, const std::string& path, const std::string& words) {
  picture.notes.push_back(fmt::format("{}: {}", path, words));
}

void finish_color(const std::string& path, Picture& picture) {
  check_largest(path, views(picture), kLargestHalf);
  size_t negative = 0;
  for (int c = 0; c < picture.channels; ++c)
    for (float& value : picture.planes[c]) {
      if (value < 0) ++negative;
      if (!(value > 0)) value = 0;  // also −0
    }
  if (negative) note(picture, path, fmt::format("{} negative color values were set to 0", negative));
  if (picture.channels == 1) {
    picture.planes[1] = picture.planes[0].clone();
    picture.planes[2] = picture.planes[0].clone();
    picture.channels = 3;
  }
}

void finish_data(const std::string& path, Picture& picture) {
  if (picture.channels != 3 || picture.planes[0] != picture.planes[1] || picture.planes[0] != picture.planes[2]) return;
  picture.channels = 1;
  picture.planes[1] = {};
  picture.planes[2] = {};
  note(picture, path, "its three channels are equal: read as one channel");
}

void finish_normal(const PictureInput& open, const PicturePlan& plan, Picture& picture) {
  const NormalNumbers numbers = reads_codes(open, plan)   ? NormalNumbers::codes
                                : plan.channels.is_vector ? NormalNumbers::vectors
                                                          : NormalNumbers::floats;
  for (const std::string& words : finish_normals(picture.planes, plan.channels.color.size(), numbers))
    note(picture, open.path, words);
  picture.channels = 3;
}

void note_layers(const PictureInput& open, const ChannelChoice& channels, PictureRole role, Picture& picture) {
  if (channels.layer.empty() && channels.other_layers.empty()) return;
  const std::string others =
      channels.other_layers.empty()
          ? ""
          : fmt::format("; {}: {}", role == PictureRole::color ? "--layer chooses another" : "not",
                        fmt::join(channels.other_layers, ", "));
  note(picture, open.path,
       channels.layer.empty() ? fmt::format("the channels without a layer were read{}", others)
                              : fmt::format("the layer \"{}\" was read{}", channels.layer, others));
}

void note_what_was_ignored(PictureInput& open, const PicturePlan& plan, size_t transparent,
                           const PictureRequest& request, Picture& picture) {
  const OIIO::ImageSpec& spec = open.spec;
  const auto add = [&](const std::string& words) { note(picture, open.path, words); };
  for (const std::string& words : open.warnings) add(words);
  if (transparent)
    add(fmt::format("alpha was dropped: {} of {} texels are not opaque{}", transparent, picture.planes[0].size(),
                    plan.is_premultiplied ? ", and their color was divided by it" : ""));
  if (plan.orientation != 1) add(fmt::format("EXIF orientation {} was applied", plan.orientation));
  if (open.format == PictureFormat::openexr && (spec.x != spec.full_x || spec.y != spec.full_y ||
                                                spec.width != spec.full_width || spec.height != spec.full_height))
    add(fmt::format("only the data window was read: {} x {} of a {} x {} frame", spec.width, spec.height,
                    spec.full_width, spec.full_height));
  note_layers(open, plan.channels, request.role, picture);
  for (const std::string& words : plan.color.notes) add(words);
  const bool has_more = open.format != PictureFormat::psd && open.input->seek_subimage(1, 0);
  if (has_more && request.layer.empty()) add("it contains several pictures: the first was read");
}

}  // namespace

Picture read_picture(const PictureRequest& request) {
  const std::string& path = request.path;
  const PictureRole role = request.role;
  check_input_file(path);
  const PngCheck png = check_png(path);
  if (png.damage) throw_reader_failure(path, *png.damage);
  const std::unique_ptr<PictureInput> open = open_picture_input(path);
  for (const std::string& words : png.warnings) open->warnings.push_back(words + ": read all the same");
  const PicturePlan plan = plan_of(*open, request, png);
  const OIIO::ImageSpec& spec = open->spec;

  Picture picture;
  picture.channels = static_cast<int>(std::min<size_t>(plan.channels.color.size(), 3));
  if (role == PictureRole::normal && request.values == PictureValues::checked) picture.channels = 3;
  picture.is_float = spec.format.is_floating_point();
  picture.source_bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(spec.format.size()) * 8);
  picture.space = plan.color.space;
  picture.name = fs::path(path).filename().string();
  picture.size_bytes = fs::file_size(path);
  picture.sha256 = sha256_file(path);

  const size_t transparent = read_planes(*open, plan, role, picture);
  picture.alpha_dropped = plan.channels.alpha >= 0;
  if (request.values == PictureValues::checked) {
    check_finite(path, views(picture));
    if (role == PictureRole::color) finish_color(path, picture);
    if (role == PictureRole::data) finish_data(path, picture);
    if (role == PictureRole::normal) finish_normal(*open, plan, picture);
  }
  note_what_was_ignored(*open, plan, transparent, request, picture);
  return picture;
}

Image<V3f> interleave(const Image<float> (&planes)[3]) {
  assert(same_size(planes[0], planes[1]) && same_size(planes[0], planes[2]));
  Image<V3f> image(planes[0].width(), planes[0].height());
  for (size_t i = 0; i < image.size(); ++i)
    image.data()[i] = {planes[0].data()[i], planes[1].data()[i], planes[2].data()[i]};
  return image;
}

}  // namespace texbake
