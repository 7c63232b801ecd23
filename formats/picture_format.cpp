#include "formats/picture_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "formats/input_file.h"
#include "libbake/base/error.h"

namespace texbake {
namespace {

using namespace std::string_view_literals;

constexpr size_t kBytesLookedAt = 132;  // DICOM has its mark last of all, from byte 128 on

struct FormatRow {
  FileFormat format;
  const char* name;
  const char* decoder;
};
constexpr FormatRow kFormats[] = {
    {FileFormat::png, "PNG", "png"},
    {FileFormat::jpeg, "JPEG", "jpeg"},
    {FileFormat::tiff, "TIFF", "tiff"},
    {FileFormat::openexr, "OpenEXR", "openexr"},
    {FileFormat::hdr, "Radiance HDR", "hdr"},
    {FileFormat::targa, "TGA", "targa"},
    {FileFormat::bmp, "BMP", "bmp"},
    {FileFormat::webp, "WebP", "webp"},
    {FileFormat::heif, "HEIF", "heif"},
    {FileFormat::dds, "DDS", "dds"},
    {FileFormat::pnm, "PNM", "pnm"},
    {FileFormat::gif, "GIF", "gif"},
    {FileFormat::jpeg2000, "JPEG 2000", "jpeg2000"},
    {FileFormat::psd, "PSD", "psd"},
};

const FormatRow& row_of(FileFormat format) {
  for (const FormatRow& row : kFormats)
    if (row.format == format) return row;
  return kFormats[0];
}

// Bytes at a place in the file that tell its format.
struct FormatMark {
  size_t at;
  std::string_view bytes;
  FileFormat format;
};
constexpr FormatMark kMarks[] = {
    {0, "\x89PNG\r\n\x1a\n"sv, FileFormat::png},
    {0, "\xff\xd8\xff"sv, FileFormat::jpeg},
    {0, "II*\0"sv, FileFormat::tiff},
    {0, "MM\0*"sv, FileFormat::tiff},
    {0, "II+\0"sv, FileFormat::tiff},
    {0, "MM\0+"sv, FileFormat::tiff},
    {0, "\x76\x2f\x31\x01"sv, FileFormat::openexr},
    {0, "#?"sv, FileFormat::hdr},
    {0, "BM"sv, FileFormat::bmp},
    {8, "WEBP"sv, FileFormat::webp},
    {4, "ftypheic"sv, FileFormat::heif},
    {4, "ftypheix"sv, FileFormat::heif},
    {4, "ftypheim"sv, FileFormat::heif},
    {4, "ftypheis"sv, FileFormat::heif},
    {4, "ftypmif1"sv, FileFormat::heif},
    {4, "ftypavif"sv, FileFormat::heif},
    {0, "DDS "sv, FileFormat::dds},
    {0, "GIF87a"sv, FileFormat::gif},
    {0, "GIF89a"sv, FileFormat::gif},
    {0, "\0\0\0\x0cjP  \r\n\x87\n"sv, FileFormat::jpeg2000},
    {0, "\xff\x4f\xff\x51"sv, FileFormat::jpeg2000},
    {0, "8BPS"sv, FileFormat::psd},
};

// What a person may have given that is not read: only named.
struct OtherMark {
  size_t at;
  std::string_view bytes;
  const char* name;
};
constexpr OtherMark kOthers[] = {
    {8, "CR\x02"sv, "a camera's raw file"},
    {0, "FUJIFILM"sv, "a camera's raw file"},
    {0, "IIU\0"sv, "a camera's raw file"},
    {0, "IIRO"sv, "a camera's raw file"},
    {0, "SIMPLE  ="sv, "FITS"},
    {0, "SDPX"sv, "DPX"},
    {0, "XPDS"sv, "DPX"},
    {0, "\x80\x2a\x5f\xd7"sv, "Cineon"},
    {0, "\x01\xda"sv, "SGI"},
    {0, "\x53\x80\xf6\x34"sv, "Softimage PIC"},
    {0, "FOR4"sv, "IFF"},
    {0, "FORM"sv, "IFF"},
    {0, "\0\0\x01\0"sv, "an icon"},
    {0, "\xabKTX"sv, "KTX"},
    {0, "\xff\x0a"sv, "JPEG XL"},
    {0, "\0\0\0\x0cJXL "sv, "JPEG XL"},
    {0, "gimp xcf"sv, "a GIMP project"},
    {0, "%PDF"sv, "PDF"},
    {0, "%!PS"sv, "PostScript"},
    {0, "<svg"sv, "SVG"},
    {0, "PK\x03\x04"sv, "a ZIP archive"},
    {128, "DICM"sv, "DICOM"},
    {4, "ftyp"sv, "a film"},
};

bool has_at(std::string_view bytes, size_t at, std::string_view mark) {
  return bytes.size() >= at + mark.size() && bytes.substr(at, mark.size()) == mark;
}

// "P1" to "P6" and "Pf", "PF", then white space.
bool is_pnm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && "123456fF"sv.find(bytes[1]) != std::string_view::npos &&
         " \t\r\n#"sv.find(bytes[2]) != std::string_view::npos;
}

// TGA has no mark: its 18 bytes must agree with each other (TGA 2.0, fields 1 to 5).
bool is_targa(std::string_view bytes) {
  if (bytes.size() < 18) return false;
  const auto byte = [&](size_t i) { return static_cast<int>(static_cast<uint8_t>(bytes[i])); };
  const auto any_of = [](int value, std::initializer_list<int> values) {
    return std::find(values.begin(), values.end(), value) != values.end();
  };
  const int map = byte(1), kind = byte(2) & ~8, bits = byte(16);
  if (map > 1 || (byte(2) & ~11) != 0 || kind < 1 || kind > 3 || (byte(17) & 0xC0) != 0) return false;
  if (byte(12) + byte(13) == 0 || byte(14) + byte(15) == 0) return false;
  if (kind == 1) return map == 1 && bits == 8 && any_of(byte(7), {15, 16, 24, 32});
  return kind == 2 ? any_of(bits, {15, 16, 24, 32}) : any_of(bits, {8, 16});
}

std::optional<FileFormat> known_format(std::string_view bytes) {
  if (has_at(bytes, 8, "CR\x02")) return std::nullopt;  // TIFF by its mark, but the first picture is a preview
  for (const FormatMark& mark : kMarks)
    if (has_at(bytes, mark.at, mark.bytes)) return mark.format;
  if (is_pnm(bytes)) return FileFormat::pnm;
  for (const OtherMark& mark : kOthers)
    if (has_at(bytes, mark.at, mark.bytes)) return std::nullopt;
  return is_targa(bytes) ? std::optional(FileFormat::targa) : std::nullopt;
}

std::string name_of_other(std::string_view bytes) {
  for (const OtherMark& mark : kOthers)
    if (has_at(bytes, mark.at, mark.bytes)) return mark.name;
  return "something else";
}

}  // namespace

FileFormat picture_format(const std::string& path) {
  const std::string bytes = file_bytes(path, kBytesLookedAt);
  if (const auto format = known_format(bytes)) return *format;
  throw Error(ErrorKind::unsupported, fmt::format("{}: format not supported: expected an image ({}), found {}; export "
                                                  "it as PNG, TIFF or OpenEXR",
                                                  path, picture_formats(), name_of_other(bytes)));
}

const char* format_name(FileFormat format) { return row_of(format).name; }

const char* decoder_name(FileFormat format) { return row_of(format).decoder; }

std::string picture_formats() {
  std::vector<std::string_view> names;
  for (const FormatRow& row : kFormats) names.emplace_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace texbake
