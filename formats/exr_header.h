// The headers of an OpenEXR file, read before OpenEXR sees it: OpenEXR takes memory for an attribute on the word of the
// four bytes that give its size, and decodes whatever compression a header names.
// Based on: "OpenEXR File Layout", header and attributes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "formats/pixel_type.h"
#include "libbake/base/torus.h"

namespace texbake {

/// What a header says of a channel.
struct ExrChannel {
  std::string name;
  PixelType type = PixelType::half;
  V2i sampling{1, 1};
};

/// What a header says of a part, as far as a bundle asks.
struct ExrPartHeader {
  std::string name;                    ///< "" in a file of one part that has none
  std::string kind = "scanlineimage";  ///< the attribute `type`
  int compression = -1;                ///< kExrZip, or another of OpenEXR's numbers; −1: none is named
  V2i low{0, 0}, high{-1, -1};         ///< dataWindow
  std::vector<ExrChannel> channels;

  /// Of one texel with all channels.
  size_t texel_bytes() const;
};

inline constexpr const char* kExrScanLines = "scanlineimage";
inline constexpr int kExrZip = 3;  ///< ZIP of sixteen rows, the one compression of a bundle

struct ExrHeaders {
  std::vector<ExrPartHeader> parts;
  /// What is wrong: no magic number, an attribute that ends beyond the file or is there twice, a part without a window
  /// or larger than a tile may be, no end. Empty when the headers could be read.
  std::string fault;
};

ExrHeaders read_exr_headers(const std::filesystem::path& path);

}  // namespace texbake
