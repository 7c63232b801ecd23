// Finds the color space that a camera notes in EXIF data without a profile: Adobe RGB.
// Based on: DCF 2.0 (option files), EXIF 2.3, §4.6.7.
#pragma once

#include <string_view>

namespace texbake {

/// Do the EXIF data in `jpeg`, the bytes of a JPEG file, name the interoperability index "R03", Adobe RGB?
bool says_adobe_rgb(std::string_view jpeg);

}  // namespace texbake
