#include "formats/image_reader.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>

#include "formats/input_file.h"
#include "formats/picture_values.h"
#include "formats/png_check.h"
#include "formats/sha256.h"
#include "formats/srgb_codes.h"
#include "libbake/base/half.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr int kRowsRead = 64;  // rows read at a time: a band of the widest picture is 50 MB

// Which of the file's channels are read.
struct Channels {
  std::vector<int> color;  // one or three
  int alpha = -1;
  bool premultiplied = false;
};

// A file that was opened: everything known before its texels are read.
struct OpenPicture {
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;
  std::string path;
  Channels channels;
  InputCurve curve = InputCurve::linear();
  int orientation = 1;
};

// The decoder's own words on one line, without its repetitions of the path.
std::string one_line(std::string words) {
  while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back()))) words.pop_back();
  std::replace(words.begin(), words.end(), '\n', ';');
  return words.empty() ? "the decoder gives no reason" : words;
}

[[noreturn]] void throw_damaged(const std::string& path, const std::string& words) {
  throw Error(
      ErrorKind::bad_data,
      fmt::format("{}: expected a complete image, found a truncated or damaged file ({}); copy or export it again",
                  path, one_line(words)));
}

std::unique_ptr<OIIO::ImageInput> open_input(const std::string& path) {
  OIIO::ImageSpec settings;
  settings["oiio:UnassociatedAlpha"] = 1;  // else the colour of PNG is multiplied by alpha
  auto input = OIIO::ImageInput::open(path, &settings);
  if (!input)
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: expected an image (PNG, JPEG, TIFF, OpenEXR, ...), found something else or a damaged "
                            "header ({})",
                            path, one_line(OIIO::geterror())));
  return input;
}

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

// "R" of "R", "diffuse.R" or "red".
char channel_letter(const std::string& name) {
  const std::string last = name.substr(name.rfind('.') + 1);
  return last.empty() ? '\0' : static_cast<char>(std::toupper(static_cast<unsigned char>(last[0])));
}

// R, G, B by name where all are there; else every channel that is neither alpha nor depth.
Channels choose_channels(const std::string& path, const OIIO::ImageSpec& spec, PictureRole role) {
  Channels channels;
  channels.alpha = spec.alpha_channel;
  channels.premultiplied = channels.alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;

  std::vector<int> rgb;
  for (const char letter : {'R', 'G', 'B'})
    for (int c = 0; c < spec.nchannels; ++c)
      if (channel_letter(spec.channelnames[c]) == letter && c != channels.alpha) {
        rgb.push_back(c);
        break;
      }
  std::vector<int> all;
  for (int c = 0; c < spec.nchannels; ++c)
    if (c != channels.alpha && c != spec.z_channel) all.push_back(c);

  channels.color = rgb.size() == 3 ? rgb : all;
  const size_t count = channels.color.size();
  const bool suits = count == 3 || (count == 1 && role != PictureRole::normal);
  if (!suits)
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected {} channels besides alpha, found {}; export it as {}",
                                                 path, role == PictureRole::normal ? "3" : "1 or 3", count,
                                                 role == PictureRole::normal ? "RGB" : "gray or RGB"));
  return channels;
}

// What the file says of its own numbers, else the custom: integers are sRGB, floats are linear.
InputCurve choose_curve(const OIIO::ImageSpec& spec, InputSpace space, PictureRole role) {
  if (role != PictureRole::color || space == InputSpace::linear) return InputCurve::linear();
  if (space == InputSpace::srgb) return InputCurve::srgb();
  const std::string said = OIIO::Strutil::lower(spec.get_string_attribute("oiio:ColorSpace"));
  if (said == "srgb") return InputCurve::srgb();
  if (said == "linear" || said.starts_with("lin_") || said == "scene_linear") return InputCurve::linear();
  const float gamma = spec.get_float_attribute("oiio:Gamma", 0);
  if (said.starts_with("gamma") && gamma > 0) return InputCurve::power(gamma);
  return spec.format.is_floating_point() ? InputCurve::linear() : InputCurve::srgb();
}

OpenPicture open_picture(const PictureRequest& request) {
  const std::string& path = request.path;
  const PictureRole role = request.role;
  OpenPicture open;
  open.path = path;
  open.input = open_input(path);
  open.spec = open.input->spec();
  check_size(path, open.spec);
  open.channels = choose_channels(path, open.spec, role);
  if (request.values == PictureValues::kept) open.channels.premultiplied = false;
  open.curve = choose_curve(open.spec, request.space, role);
  open.orientation = open.spec.get_int_attribute("Orientation", 1);
  if (open.orientation < 1 || open.orientation > 8) open.orientation = 1;
  if (role == PictureRole::normal && open.orientation != 1)
    throw Error(ErrorKind::unsupported, fmt::format("{}: expected an upright normal map, found EXIF orientation {}; "
                                                    "its vectors would have to rotate too: export it upright",
                                                    path, open.orientation));
  return open;
}

// Integers of 8 and 16 bits are decoded by table, everything else as floats.
bool reads_codes(const OpenPicture& open) {
  const OIIO::ImageSpec& spec = open.spec;
  return !open.channels.premultiplied && spec.channelformats.empty() &&
         (spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16);
}

// What one code of an integer file.
std::vector<float> code_table(int bits, PictureRole role, const InputCurve& curve) {
  const int codes = 1 << bits;
  std::vector<float> table(static_cast<size_t>(codes));
  for (int code = 0; code < codes; ++code)
    table[code] = role == PictureRole::normal ? normal_from_code(static_cast<uint16_t>(code), bits)
                                              : curve.decode(static_cast<float>(code) / static_cast<float>(codes - 1));
  return table;
}

// Reads rows begin … end − 1 of the file, all channels below `channel_count`.
template <class Sample>
void read_band(OpenPicture& open, int begin, int end, int channel_count, std::vector<Sample>& band) {
  const OIIO::ImageSpec& spec = open.spec;
  band.resize(static_cast<size_t>(spec.width) * static_cast<size_t>(end - begin) * static_cast<size_t>(channel_count));
  const auto type = OIIO::TypeDesc(OIIO::BaseTypeFromC<Sample>::value);
  const bool read =
      spec.tile_width > 0
          ? open.input->read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end, spec.z, spec.z + 1,
                                   0, channel_count, type, band.data())
          : open.input->read_scanlines(0, 0, spec.y + begin, spec.y + end, spec.z, 0, channel_count, type, band.data());

  // Decoders pad what is missing with grey and only warn; stray bytes alone change no texel.
  const std::string words = open.input->geterror();
  const bool harmless = words.find("extraneous bytes") != std::string::npos &&
                        words.find("premature end") == std::string::npos &&
                        words.find("Premature end") == std::string::npos;
  if (!read || (!words.empty() && !harmless)) throw_damaged(open.path, words);
}

// Calls `place(p, samples)` with every texel of the file, rows in parallel. `prepare` is called once after the first
// rows were read well: a header that lies about the size is found before memory is taken.
template <class Sample, class Prepare, class Place>
void read_texels(OpenPicture& open, const Prepare& prepare, const Place& place) {
  const OIIO::ImageSpec& spec = open.spec;
  const int channel_count =
      1 + std::max(open.channels.alpha, *std::max_element(open.channels.color.begin(), open.channels.color.end()));
  const int band_rows = spec.tile_width > 0 ? spec.tile_height : kRowsRead;
  std::vector<Sample> band;
  for (int begin = 0; begin < spec.height; begin += band_rows) {
    const int end = std::min(begin + band_rows, spec.height);
    read_band(open, begin, end, channel_count, band);
    if (begin == 0) prepare();
    parallel_for(begin, end, [&](int y) {
      const Sample* samples =
          band.data() + static_cast<size_t>(y - begin) * static_cast<size_t>(spec.width) * channel_count;
      for (int x = 0; x < spec.width; ++x, samples += channel_count) place(V2i(x, y), samples);
    });
  }
}
// Decodes every texel into upright planes; returns how many texels are not opaque.
size_t read_planes(OpenPicture& open, PictureRole role, Picture& picture) {
  const OIIO::ImageSpec& spec = open.spec;
  const V2i stored(spec.width, spec.height);
  const V2i upright = upright_size(stored, open.orientation);
  const std::vector<int>& color = open.channels.color;
  const int alpha = open.channels.alpha;
  const bool divides = open.channels.premultiplied;
  std::vector<size_t> transparent(static_cast<size_t>(spec.height), 0);  // in each row of the file

  const auto prepare = [&] {
    for (size_t c = 0; c < color.size(); ++c) picture.planes[c] = Image<float>(upright.x, upright.y);
  };
  const auto read_codes = [&]<class Sample>(Sample highest) {
    const std::vector<float> table = code_table(8 * static_cast<int>(sizeof(Sample)), role, open.curve);
    read_texels<Sample>(open, prepare, [&](V2i p, const Sample* samples) {
      const V2i place = upright_place(p, stored, open.orientation);
      for (size_t c = 0; c < color.size(); ++c) picture.planes[c](place.x, place.y) = table[samples[color[c]]];
      if (alpha >= 0 && samples[alpha] != highest) ++transparent[p.y];
    });
  };
  if (reads_codes(open) && spec.format == OIIO::TypeDesc::UINT8) {
    read_codes(uint8_t{255});
  } else if (reads_codes(open)) {
    read_codes(uint16_t{65535});
  } else {
    read_texels<float>(open, prepare, [&](V2i p, const float* samples) {
      const V2i place = upright_place(p, stored, open.orientation);
      const float opacity = alpha >= 0 ? samples[alpha] : 1.0f;
      const float divisor = divides && opacity > 0 ? opacity : 1.0f;
      for (size_t c = 0; c < color.size(); ++c)
        picture.planes[c](place.x, place.y) = open.curve.decode(samples[color[c]] / divisor);
      if (opacity != 1) ++transparent[p.y];
    });
  }
  return std::accumulate(transparent.begin(), transparent.end(), size_t{0});
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

// Integers are vectors by code; what was read as 0 … 1 becomes −1 … 1.
void finish_normal(const std::string& path, Picture& picture, bool decoded_by_code) {
  if (decoded_by_code) return;
  const auto negative = [](const Image<float>& plane) {
    return std::any_of(plane.begin(), plane.end(), [](float value) { return value < 0; });
  };
  if (std::any_of(picture.planes, picture.planes + 3, negative)) return;
  for (Image<float>& plane : picture.planes)
    for (float& value : plane) value = 2 * value - 1;
  note(picture, path, "no component is negative: 0 to 1 is taken to mean -1 to 1");
}

void note_what_was_ignored(OpenPicture& open, size_t transparent, PictureRole role, Picture& picture) {
  const OIIO::ImageSpec& spec = open.spec;
  const auto add = [&](const std::string& words) { note(picture, open.path, words); };
  if (transparent)
    add(fmt::format("alpha was dropped: {} of {} texels are not opaque{}", transparent, picture.planes[0].size(),
                    open.channels.premultiplied ? ", and their color was divided by it" : ""));
  if (open.orientation != 1) add(fmt::format("EXIF orientation {} was applied", open.orientation));
  if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
      spec.height != spec.full_height)
    add(fmt::format("only the data window was read: {} x {} of a {} x {} frame", spec.width, spec.height,
                    spec.full_width, spec.full_height));
  const std::string profile = spec.get_string_attribute("ICCProfile:profile_description");
  if (role == PictureRole::color && !profile.empty() && OIIO::Strutil::lower(profile).find("srgb") == std::string::npos)
    add(fmt::format("its color profile \"{}\" is not applied: values are taken as Rec.709 primaries, {}", profile,
                    picture.space));
  if (open.input->seek_subimage(1, 0)) add("it contains several pictures: the first was read");
}

}  // namespace

Picture read_picture(const PictureRequest& request) {
  const std::string& path = request.path;
  const PictureRole role = request.role;
  check_input_file(path);
  if (const auto damage = find_png_damage(path)) throw_damaged(path, *damage);
  OpenPicture open = open_picture(request);
  const OIIO::ImageSpec& spec = open.spec;

  Picture picture;
  picture.channels = static_cast<int>(open.channels.color.size());
  picture.is_float = spec.format.is_floating_point();
  picture.source_bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(spec.format.size()) * 8);
  picture.space = open.curve.name();
  picture.name = fs::path(path).filename().string();
  picture.size_bytes = fs::file_size(path);
  picture.sha256 = sha256_file(path);

  const size_t transparent = read_planes(open, role, picture);
  picture.alpha_dropped = open.channels.alpha >= 0;
  if (request.values == PictureValues::checked) {
    check_finite(path, views(picture));
    if (role == PictureRole::color) finish_color(path, picture);
    if (role == PictureRole::data) finish_data(path, picture);
    if (role == PictureRole::normal) finish_normal(path, picture, reads_codes(open));
  }
  note_what_was_ignored(open, transparent, role, picture);
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
