// The picture formats that are read, and which of them a file has: by its first bytes, never by its name.
#pragma once

#include <string>

namespace texbake {

enum class FileFormat {
  png,
  jpeg,
  tiff,
  openexr,
  hdr,
  targa,
  bmp,
  webp,
  heif,  ///< HEIC and AVIF
  dds,
  pnm,
  gif,
  jpeg2000,
  psd,
};

/// Of the file at `path`. Throws Error(io) when it cannot be read, and Error(unsupported), naming the format that was
/// found where it is known, for one that is not in the list.
FileFormat picture_format(const std::string& path);

/// The name that people use: "PNG", "OpenEXR".
const char* format_name(FileFormat format);

/// The name of OpenImageIO's reader for `format`, which opens nothing else.
const char* decoder_name(FileFormat format);

/// All formats for people: "PNG, JPEG, ...".
std::string picture_formats();

}  // namespace texbake
