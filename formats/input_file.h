// Says what is wrong with the path of an input before a decoder sees it.
#pragma once

#include <string>

namespace texbake {

/// Throws Error(io) unless `path` is a regular file that can be opened for reading, Error(bad_data) when it is empty.
void check_input_file(const std::string& path);

}  // namespace texbake
