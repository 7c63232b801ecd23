// Reads a PNG file chunk by chunk, before a decoder does: what is damaged, and what the file says of its colors.
// Based on: ISO/IEC 15948 (PNG), §5, §11.3 and annex D.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace texbake {

struct PngCheck {
  /// A critical chunk whose checksum differs or that the file ends inside of; nothing for a sound file.
  std::optional<std::string> damage = {};
  /// What is wrong but changes no texel: the checksum of an ancillary chunk, or no IEND. Bytes after IEND are allowed.
  std::vector<std::string> warnings = {};
  /// The content of the sound chunks cICP, sRGB, gAMA and cHRM, by name.
  std::map<std::string, std::string> color_chunks = {};
};

/// Of the file at `path`. A file that is no PNG has neither damage nor warnings.
PngCheck check_png(const std::string& path);

}  // namespace texbake
