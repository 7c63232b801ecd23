// Files for the tests of the image reader and writer: made here, in a folder of their own.
#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libbake/base/error.h"

namespace texbake {

/// The error that an action raises, as kind and words; neither when it raises none.
struct Refusal {
  std::optional<ErrorKind> kind;
  std::string words;
};
template <class Action>
Refusal refusal(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return {error.kind(), error.what()};
  }
  return {};
}

/// A new folder that disappears with the test.
class PictureFolder {
 public:
  PictureFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "texbake-pictures-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~PictureFolder() { std::filesystem::remove_all(path_); }
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  size_t file_count() const {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

inline void write_bytes(const std::string& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Writes interleaved samples by OpenImageIO itself. The caller may set attributes in `spec` first.
template <class Sample>
void save_picture(const std::string& path, const OIIO::ImageSpec& spec, const std::vector<Sample>& samples) {
  auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output) << OIIO::geterror();
  ASSERT_TRUE(output->open(path, spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc(OIIO::BaseTypeFromC<Sample>::value), samples.data()))
      << output->geterror();
  ASSERT_TRUE(output->close()) << output->geterror();
}

/// A PNG file from its parts: `rows` are the packed bytes of each row, without filter bytes. Stored, not compressed.
struct PngParts {
  uint32_t width = 0;
  uint32_t height = 0;
  uint8_t bit_depth = 8;
  uint8_t color_type = 0;         ///< 0 gray, 2 RGB, 3 palette, 4 gray + alpha, 6 RGBA
  std::string extra_chunks = {};  ///< made by `png_chunk`, before the texels
  std::vector<std::string> rows = {};
};

inline std::string big_endian(uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

inline std::string png_chunk(const std::string& name, const std::string& data) {
  uint32_t crc = 0xFFFFFFFFu;
  for (const char c : name + data) {
    crc ^= static_cast<uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xEDB88320u : 0);
  }
  return big_endian(static_cast<uint32_t>(data.size())) + name + data + big_endian(~crc);
}

inline std::string png_bytes(const PngParts& parts) {
  std::string raw;
  for (const std::string& row : parts.rows) raw += '\0' + row;
  uint32_t a = 1, b = 0;
  for (const char c : raw) {
    a = (a + static_cast<uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<uint16_t>(raw.size());
  std::string zlib = "\x78\x01\x01";
  for (const int value : {size & 255, size >> 8, ~size & 255, (~size >> 8) & 255}) zlib += static_cast<char>(value);
  zlib += raw + big_endian(b << 16 | a);
  std::string header = big_endian(parts.width) + big_endian(parts.height);
  header += static_cast<char>(parts.bit_depth);
  header += static_cast<char>(parts.color_type);
  header += std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + parts.extra_chunks + png_chunk("IDAT", zlib) +
         png_chunk("IEND", "");
}

}  // namespace texbake
