#include "formats/picture_texels.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "formats/srgb_codes.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr int kRowsRead = 64;  // rows read at a time, at least: a band of the widest picture is 50 MB

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
  if (open.format != FileFormat::tiff) return kRowsRead;
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

  // Decoders pad what is missing with gray and only warn; stray bytes alone change no texel.
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

}  // namespace

bool reads_codes(const PictureInput& open, const PicturePlan& plan) {
  const OIIO::ImageSpec& spec = open.spec;
  return !plan.is_premultiplied && !plan.color.transform && spec.channelformats.empty() &&
         (spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16);
}

size_t read_texels(PictureInput& open, const PicturePlan& plan, PictureRole role, Picture& picture) {
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

}  // namespace texbake
