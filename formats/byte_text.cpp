#include "formats/byte_text.h"

#include <algorithm>

namespace texbake {
namespace {

constexpr unsigned kFirstRaw = 0xEF80, kLastRaw = 0xEFFF, kRawBase = 0xEF00;

bool is_raw_byte(const CodePoint& point) {
  return point.bytes > 0 && point.value >= kFirstRaw && point.value <= kLastRaw;
}

void append_raw(char byte, std::string& text) {
  const unsigned value = kRawBase + static_cast<unsigned char>(byte);
  text += static_cast<char>(0xE0 | value >> 12);
  text += static_cast<char>(0x80 | (value >> 6 & 0x3F));
  text += static_cast<char>(0x80 | (value & 0x3F));
}

}  // namespace

CodePoint first_code_point(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {1, lead};
  const size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4) return {};
  unsigned value = lead & (0x7Fu >> bytes);
  for (size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3F);
  }
  constexpr unsigned kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = value >= 0xD800 && value <= 0xDFFF;
  return value < kLeast[bytes] || value > 0x10FFFF || is_surrogate ? CodePoint() : CodePoint{bytes, value};
}

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const CodePoint point = first_code_point(bytes);
    if (point.bytes == 0) return false;
    bytes.remove_prefix(point.bytes);
  }
  return true;
}

std::string text_of_bytes(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const CodePoint point = first_code_point(bytes);
    const std::string_view part = bytes.substr(0, std::max<size_t>(point.bytes, 1));
    if (point.bytes > 0 && !is_raw_byte(point))
      text += part;
    else
      for (const char byte : part) append_raw(byte, text);
    bytes.remove_prefix(part.size());
  }
  return text;
}

std::string bytes_of_text(std::string_view text) {
  std::string bytes;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    const std::string_view part = text.substr(0, std::max<size_t>(point.bytes, 1));
    if (is_raw_byte(point))
      bytes += static_cast<char>(point.value - kRawBase);
    else
      bytes += part;
    text.remove_prefix(part.size());
  }
  return bytes;
}

}  // namespace texbake
