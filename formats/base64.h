// Bytes as text, for data inside pages and scripts. Based on: RFC 4648, §4.
#pragma once

#include <cstddef>
#include <string>

namespace texbake {

/// With padding, without line breaks.
std::string base64(const void* data, size_t count);

}  // namespace texbake
