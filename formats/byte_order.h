// Numbers in the bytes of files, in either order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace texbake {

/// The number that the `count` bytes from `at` on are, at most eight, all of them in `bytes`; the most significant
/// first.
inline uint64_t big_endian(std::string_view bytes, size_t at, size_t count) {
  uint64_t value = 0;
  for (size_t i = 0; i < count; ++i) value = value << 8 | static_cast<uint8_t>(bytes[at + i]);
  return value;
}

/// The same with the least significant first.
inline uint64_t little_endian(std::string_view bytes, size_t at, size_t count) {
  uint64_t value = 0;
  for (size_t i = count; i-- > 0;) value = value << 8 | static_cast<uint8_t>(bytes[at + i]);
  return value;
}

}  // namespace texbake
