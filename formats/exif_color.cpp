#include "formats/exif_color.h"

#include <cstddef>
#include <optional>

#include "formats/byte_order.h"

namespace texbake {
namespace {

constexpr std::string_view kExifMark("Exif\0\0", 6);
constexpr int kExifDirectory = 0x8769, kInteropDirectory = 0xA005, kInteropIndex = 1;
constexpr size_t kEntryBytes = 12;

// The TIFF structure inside EXIF data.
class ExifData {
 public:
  explicit ExifData(std::string_view bytes) : bytes_(bytes), is_big_(bytes.substr(0, 2) == "MM") {}

  /// The number of `count` bytes at `at`; 0 beyond the end.
  size_t number(size_t at, size_t count) const {
    if (at + count > bytes_.size()) return 0;
    return is_big_ ? big_endian(bytes_, at, count) : little_endian(bytes_, at, count);
  }
  /// Where the value of `tag` lies in the directory at `directory`.
  std::optional<size_t> find(size_t directory, int tag) const {
    const size_t entries = number(directory, 2);
    for (size_t i = 0, at = directory + 2; i < entries && at + kEntryBytes <= bytes_.size(); ++i, at += kEntryBytes)
      if (number(at, 2) == static_cast<size_t>(tag)) return at + 8;
    return std::nullopt;
  }
  bool has_text(size_t at, std::string_view text) const {
    return at + text.size() <= bytes_.size() && bytes_.substr(at, text.size()) == text;
  }

 private:
  std::string_view bytes_;
  bool is_big_;
};

}  // namespace

bool says_adobe_rgb(std::string_view jpeg) {
  const size_t mark = jpeg.substr(0, size_t{1} << 16).find(kExifMark);
  if (mark == std::string_view::npos) return false;
  const ExifData exif(jpeg.substr(mark + kExifMark.size()));
  const auto details = exif.find(exif.number(4, 4), kExifDirectory);
  if (!details) return false;
  const auto interop = exif.find(exif.number(*details, 4), kInteropDirectory);
  if (!interop) return false;
  const auto index = exif.find(exif.number(*interop, 4), kInteropIndex);
  return index && exif.has_text(*index, "R03");
}

}  // namespace texbake
