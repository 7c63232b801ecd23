#include "formats/png_check.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

#include "formats/byte_order.h"

namespace texbake {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";

uint32_t add_crc(uint32_t crc, const char* bytes, size_t count) {
  return static_cast<uint32_t>(crc32(crc, reinterpret_cast<const Bytef*>(bytes), static_cast<uInt>(count)));
}

// Reads exactly `count` bytes.
bool read_exactly(std::istream& file, char* bytes, size_t count) {
  return static_cast<bool>(file.read(bytes, static_cast<std::streamsize>(count)));
}

// One chunk of a file.
struct PngChunk {
  std::string name;
  std::string start;     // of its content, at most kKeptBytes
  bool is_whole = true;  // the file does not end inside of it
  bool is_sound = true;  // its checksum is right

  bool is_ancillary() const { return std::islower(static_cast<unsigned char>(name[0])); }
  bool is_end() const { return name == "IEND"; }
};

constexpr size_t kKeptBytes = 32;  // cHRM, the longest chunk of interest

// The content and the checksum of the chunk whose head was read.
PngChunk read_chunk(std::istream& file, const char (&head)[8]) {
  PngChunk chunk{.name = std::string(head + 4, 4), .start = {}};
  uint32_t length = static_cast<uint32_t>(big_endian({head, 4}, 0, 4));
  std::vector<char> block(std::min<size_t>(length, size_t{1} << 16));
  uint32_t crc = add_crc(0, chunk.name.data(), chunk.name.size());
  while (length > 0) {
    const size_t count = std::min<size_t>(length, block.size());
    if (!read_exactly(file, block.data(), count)) {
      chunk.is_whole = false;
      return chunk;
    }
    if (chunk.start.empty()) chunk.start.assign(block.data(), std::min(count, kKeptBytes));
    crc = add_crc(crc, block.data(), count);
    length -= static_cast<uint32_t>(count);
  }
  char tail[4];
  chunk.is_whole = read_exactly(file, tail, sizeof(tail));
  chunk.is_sound = chunk.is_whole && crc == big_endian({tail, 4}, 0, 4);
  return chunk;
}

bool is_color_chunk(const std::string& name) {
  return name == "cICP" || name == "sRGB" || name == "gAMA" || name == "cHRM";
}

// Takes a chunk into account; false where the walk ends.
bool note_chunk(PngChunk chunk, bool has_texels, PngCheck& check) {
  const bool is_harmless = chunk.is_ancillary() || chunk.is_end();
  if (!chunk.is_whole) {
    const std::string words = fmt::format("the file ends inside the chunk {}", chunk.name);
    if (is_harmless && has_texels)
      check.warnings.push_back(words);
    else
      check.damage = words;
    return false;
  }
  if (!chunk.is_sound) {
    const std::string words = fmt::format("the checksum of the chunk {} is wrong", chunk.name);
    if (!is_harmless) {
      check.damage = words;
      return false;
    }
    check.warnings.push_back(words);
  } else if (is_color_chunk(chunk.name)) {
    check.color_chunks.emplace(chunk.name, std::move(chunk.start));
  }
  return !chunk.is_end();
}

}  // namespace

PngCheck check_png(const std::string& path) {
  PngCheck check;
  std::ifstream file(path, std::ios::binary);
  char signature[kSignature.size()];
  if (!read_exactly(file, signature, sizeof(signature)) || std::string_view(signature, sizeof(signature)) != kSignature)
    return check;

  bool has_texels = false;
  for (;;) {
    char head[8];
    if (!read_exactly(file, head, sizeof(head))) {
      const std::string words = "the file ends before the chunk IEND";
      if (has_texels)
        check.warnings.push_back(words);
      else
        check.damage = words;
      return check;
    }
    if (!std::all_of(head + 4, head + 8, [](unsigned char c) { return std::isalpha(c); })) {
      check.damage = fmt::format("expected a chunk {} bytes into the file", static_cast<int64_t>(file.tellg()) - 8);
      return check;
    }
    PngChunk chunk = read_chunk(file, head);
    has_texels = has_texels || chunk.name == "IDAT";
    if (!note_chunk(std::move(chunk), has_texels, check)) return check;
  }
}

}  // namespace texbake
