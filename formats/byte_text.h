// File names and messages as text: bytes that need not be UTF-8, in JSON, which must be.
// Based on: OPTU-8 of MirBSD, which keeps raw octets in the private use area of Unicode.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace texbake {

struct CodePoint {
  size_t bytes = 0;  ///< 0: there is no well-formed character
  unsigned value = 0;
};

/// The character that `text` begins with. Based on: Unicode 15, table 3-7.
CodePoint first_code_point(std::string_view text);

/// Is `bytes` well-formed UTF-8?
bool is_utf8(std::string_view bytes);

/// `bytes` as UTF-8. Each byte b that belongs to no well-formed character becomes the character U+EF00 + b, and so do
/// the bytes of the characters U+EF80 to U+EFFF: all else stays as it is, and bytes_of_text gives back every byte.
std::string text_of_bytes(std::string_view bytes);

/// The bytes that text_of_bytes has made `text` of. Bytes that are no UTF-8 stay as they are.
std::string bytes_of_text(std::string_view text);

}  // namespace texbake
