#include "formats/png_check.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

namespace texbake {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";

uint32_t add_crc(uint32_t crc, const char* bytes, size_t count) {
  return static_cast<uint32_t>(crc32(crc, reinterpret_cast<const Bytef*>(bytes), static_cast<uInt>(count)));
}

uint32_t big_endian(const char* bytes) {
  uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[i]);
  return value;
}

// Reads exactly `count` bytes.
bool read_exactly(std::istream& file, char* bytes, size_t count) {
  return static_cast<bool>(file.read(bytes, static_cast<std::streamsize>(count)));
}

// Checksum of the next `length` bytes, begun with the chunk's name; nothing when the file ends before.
std::optional<uint32_t> crc_of_chunk(std::istream& file, std::string_view name, uint32_t length) {
  std::vector<char> block(std::min<size_t>(length, size_t{1} << 16));
  uint32_t crc = add_crc(0, name.data(), name.size());
  while (length > 0) {
    const size_t count = std::min<size_t>(length, block.size());
    if (!read_exactly(file, block.data(), count)) return std::nullopt;
    crc = add_crc(crc, block.data(), count);
    length -= static_cast<uint32_t>(count);
  }
  return crc;
}

}  // namespace

std::optional<std::string> find_png_damage(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char signature[kSignature.size()];
  if (!read_exactly(file, signature, sizeof(signature)) || std::string_view(signature, sizeof(signature)) != kSignature)
    return std::nullopt;

  for (;;) {
    char head[8], tail[4];
    if (!read_exactly(file, head, sizeof(head))) return "the file ends before the chunk IEND";
    const std::string_view name(head + 4, 4);
    if (!std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c); }))
      return fmt::format("expected a chunk {} bytes into the file", static_cast<int64_t>(file.tellg()) - 8);
    const std::optional<uint32_t> crc = crc_of_chunk(file, name, big_endian(head));
    if (!crc || !read_exactly(file, tail, sizeof(tail))) return fmt::format("the file ends inside the chunk {}", name);
    if (*crc != big_endian(tail)) return fmt::format("the checksum of the chunk {} is wrong", name);
    if (name == "IEND") return std::nullopt;
  }
}

}  // namespace texbake
