// Says what is wrong with the path of an input before a decoder sees it, and reads what is text.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace texbake {

/// Throws Error(io) unless `path` is a regular file that can be opened for reading, Error(bad_data) when it is empty.
void check_input_file(const std::string& path);

/// Does only a lack of permission, for the file or a folder above it, keep this process from reading `path`?
bool is_forbidden(const std::filesystem::path& path);

/// The bytes of the file at `path`, but no more than the first `most`. Throws Error(io).
std::string file_bytes(const std::string& path, size_t most = std::string::npos);

}  // namespace texbake
