#include "formats/color_facts.h"

#include <cstdint>
#include <string_view>

#include "formats/byte_order.h"
#include "formats/exif_color.h"
#include "formats/input_file.h"

namespace texbake {
namespace {

constexpr size_t kExifEnd = size_t{1} << 17;  // it begins within the first 64 KiB of a file, and is no longer than that
constexpr int kExifUncalibrated = 65535;      // EXIF 2.3, ColorSpace: not sRGB

double png_number(std::string_view bytes, size_t at) {  // PNG stores 100000 times the number
  return static_cast<double>(big_endian(bytes, at, 4)) / 100000.0;
}

// cICP before iCCP before sRGB before gAMA and cHRM (PNG, third edition, §4.3).
void add_png(const std::string& path, const PngCheck& png, ColorFacts& facts) {
  const auto content = [&](const char* name, size_t size) {
    const auto chunk = png.color_chunks.find(name);
    return chunk != png.color_chunks.end() && chunk->second.size() == size ? chunk->second : std::string();
  };
  if (const std::string cicp = content("cICP", 4); !cicp.empty()) {
    facts.profile.clear();
    facts.source = "its chunk cICP";
    add_code_points(path, static_cast<uint8_t>(cicp[0]), static_cast<uint8_t>(cicp[1]), facts);
    return;
  }
  if (!facts.profile.empty()) return;
  if (!content("sRGB", 1).empty()) {
    facts.curve = InputCurve::srgb();
    return;
  }
  if (const std::string chrm = content("cHRM", 32); !chrm.empty()) {  // white, red, green, blue
    Chromaticities c{};
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 2; ++k) c.xy[i][k] = png_number(chrm, static_cast<size_t>(8 * ((i + 1) % 4) + 4 * k));
    facts.primaries = c;
    facts.source = "its chunk cHRM";
  }
}

// PNG that names primaries of its own means its gamma as it says.
void make_gamma_exact(const PngCheck& png, ColorFacts& facts) {
  const auto gama = png.color_chunks.find("gAMA");
  if (!facts.primaries || is_rec709(*facts.primaries) || !facts.profile.empty() || png.color_chunks.contains("sRGB") ||
      png.color_chunks.contains("cICP") || gama == png.color_chunks.end() || gama->second.size() != 4)
    return;
  const double encoding = png_number(gama->second, 0);
  if (encoding > 0.01) facts.curve = InputCurve::exact_power(1 / encoding);
}

// One box of a HEIF file after the other (ISO/IEC 14496-12): finds the first "colr" of `kind`.
std::string_view color_box(std::string_view bytes, std::string_view kind) {
  for (size_t at = bytes.find("colr"); at != std::string_view::npos; at = bytes.find("colr", at + 4)) {
    if (at < 4 || bytes.substr(at + 4, 4) != kind) continue;
    const uint64_t size = big_endian(bytes, at - 4, 4);
    if (size >= 12 && at - 4 + size <= bytes.size()) return bytes.substr(at + 8, size - 12);
  }
  return {};
}

void add_heif(const std::string& path, ColorFacts& facts) {
  const std::string bytes = file_bytes(path);
  const std::string_view all = bytes;
  std::string_view profile = color_box(all, "prof");
  if (profile.empty()) profile = color_box(all, "rICC");
  if (!profile.empty()) {
    facts.profile = profile;
    return;
  }
  const std::string_view nclx = color_box(all, "nclx");
  if (nclx.size() < 4) return;
  facts.source = "its box nclx";
  const auto number = [&](size_t at) { return static_cast<int>(big_endian(nclx, at, 2)); };
  add_code_points(path, number(0), number(2), facts);
}

// The profile of a WebP file (RIFF): OpenImageIO hands out none.
void add_webp(const std::string& path, ColorFacts& facts) {
  const std::string bytes = file_bytes(path);
  for (size_t at = 12; at + 8 <= bytes.size();) {
    const uint64_t size = little_endian(bytes, at + 4, 4);
    if (bytes.compare(at, 4, "ICCP") == 0 && at + 8 + size <= bytes.size()) facts.profile = bytes.substr(at + 8, size);
    at += 8 + size + (size & 1);
  }
}

void add_openexr(const OIIO::ImageSpec& spec, ColorFacts& facts) {
  const OIIO::ParamValue* const attribute = spec.find_attribute("chromaticities");
  if (!attribute || attribute->type().basevalues() != 8 || attribute->type().basetype != OIIO::TypeDesc::FLOAT) return;
  const auto* const values = static_cast<const float*>(attribute->data());
  Chromaticities c{};
  for (int i = 0; i < 8; ++i) c.xy[i / 2][i % 2] = static_cast<double>(values[i]);
  facts.primaries = c;
  facts.source = "its attribute chromaticities";
}

// A camera that notes Adobe RGB, and embeds no profile (Adobe RGB (1998), §4.3).
void add_jpeg(const std::string& path, ColorFacts& facts) {
  if (!facts.profile.empty() || !says_adobe_rgb(file_bytes(path, kExifEnd))) return;
  facts.primaries = {{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, {0.3127, 0.3290}}};
  facts.curve = InputCurve::exact_power(563.0 / 256.0);
  facts.source = "its EXIF data, Adobe RGB";
}

std::string embedded_profile(const OIIO::ImageSpec& spec) {
  const OIIO::ParamValue* const attribute = spec.find_attribute("ICCProfile");
  if (!attribute) return {};
  return {static_cast<const char*>(attribute->data()), static_cast<size_t>(attribute->datasize())};
}

// What OpenImageIO itself understood of the curve.
void add_said_curve(const OIIO::ImageSpec& spec, ColorFacts& facts) {
  const std::string said = OIIO::Strutil::lower(spec.get_string_attribute("oiio:ColorSpace"));
  const float gamma = spec.get_float_attribute("oiio:Gamma", 0);
  if (said == "srgb") facts.curve = InputCurve::srgb();
  if (said == "linear" || said.starts_with("lin_") || said == "scene_linear") facts.curve = InputCurve::linear();
  if (said.starts_with("gamma") && gamma > 0) facts.curve = InputCurve::power(gamma);
}

}  // namespace

ColorFacts color_facts(const PictureInput& open, const PngCheck& png) {
  ColorFacts facts;
  facts.profile = embedded_profile(open.spec);
  add_said_curve(open.spec, facts);
  switch (open.format) {
    case FileFormat::png:
      add_png(open.path, png, facts);
      make_gamma_exact(png, facts);
      break;
    case FileFormat::jpeg:
      add_jpeg(open.path, facts);
      break;
    case FileFormat::heif:
      add_heif(open.path, facts);
      break;
    case FileFormat::webp:
      add_webp(open.path, facts);
      break;
    case FileFormat::openexr:
      add_openexr(open.spec, facts);
      break;
    default:
      break;
  }
  if (facts.profile.empty() && !facts.primaries && open.spec.get_int_attribute("Exif:ColorSpace") == kExifUncalibrated)
    facts.doubt =
        "its EXIF data says that its colors are not sRGB, but no profile says what they are: Rec.709 primaries are "
        "assumed";
  return facts;
}

}  // namespace texbake
