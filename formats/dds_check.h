// Refuses a DDS file whose header would lead its decoder astray.
// Based on: Microsoft, "DDS_HEADER structure" and "DDS_PIXELFORMAT structure".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace texbake {

inline constexpr size_t kDdsHeaderBytes = 128;

/// `header` are the first kDdsHeaderBytes bytes of the file at `path`, which has `file_size` bytes. Throws
/// Error(unsupported) for luminance and for alpha alone, and Error(bad_data) for masks that select no bits and for
/// texels that lie beyond the end of the file.
void check_dds(const std::string& path, std::string_view header, uint64_t file_size);

}  // namespace texbake
