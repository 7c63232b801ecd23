// Finds a PNG file that is cut off or damaged, chunk by chunk, before a decoder complains on its own.
// Based on: ISO/IEC 15948 (PNG), §5 and annex D.
#pragma once

#include <optional>
#include <string>

namespace texbake {

/// What is wrong with the chunks of the PNG file at `path`: one that ends beyond the file, one whose checksum differs,
/// or no IEND. Nothing for a sound file, and for a file that is no PNG. Bytes after IEND are allowed.
std::optional<std::string> find_png_damage(const std::string& path);

}  // namespace texbake
