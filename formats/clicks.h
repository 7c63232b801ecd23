// The heights that a person gave at some texels, as they stand in a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libbake/base/torus.h"
#include "libbake/height/heightmap.h"

namespace texbake {

struct ClickFile {
  std::vector<HeightClick> clicks;  ///< in the order of the file; a picture's row by row
  std::optional<V2i> picture_size;  ///< of a sparse picture
  std::string name;                 ///< of the file, without its folder
  std::string sha256;               ///< of its bytes
  uint64_t size_bytes = 0;
};

}  // namespace texbake
