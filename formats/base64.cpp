#include "formats/base64.h"

#include <openssl/evp.h>

#include <algorithm>

namespace texbake {

std::string base64(const void* data, size_t count) {
  constexpr size_t kPart = size_t{3} << 20;         // OpenSSL counts in int; a multiple of three needs no padding
  std::string text((count + 2) / 3 * 4 + 1, '\0');  // OpenSSL ends each part with a zero
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (size_t i = 0; i < count; i += kPart)
    EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()) + i / 3 * 4, bytes + i,
                    static_cast<int>(std::min(kPart, count - i)));
  text.pop_back();
  return text;
}

}  // namespace texbake
