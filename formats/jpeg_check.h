// Tells a JPEG file that only lacks its end marker from one that is cut off.
// Based on: ITU-T T.81, annex B.
#pragma once

#include <string_view>

namespace texbake {

/// Is there no end marker after the only scan of a sequential JPEG file? A decoder that is handed the missing marker
/// complains where texels are missing too. False for files of several scans, where it would not.
bool lacks_only_end_marker(std::string_view bytes);

}  // namespace texbake
