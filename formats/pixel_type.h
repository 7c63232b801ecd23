// How the values of a plane are stored.
#pragma once

#include <cstddef>

namespace texbake {

/// The names in the manifest are "uint", "half" and "float".
enum class PixelType {
  uint,     ///< 32-bit unsigned
  half,     ///< IEEE binary16
  float32,  ///< IEEE binary32
};

inline size_t bytes_of(PixelType type) { return type == PixelType::half ? 2 : 4; }

inline const char* name_of(PixelType type) {
  if (type == PixelType::uint) return "uint";
  return type == PixelType::half ? "half" : "float";
}

}  // namespace texbake
