// A look at the headers of an OpenEXR file before OpenEXR reads them: it takes memory for an attribute on the word of
// the four bytes that give its size. Based on: "OpenEXR File Layout", header and attributes.
#pragma once

#include <filesystem>
#include <string>

namespace texbake {

/// What is wrong with the headers: no magic number, an attribute that ends beyond the file, no end. Empty when an
/// OpenEXR library may read the file.
std::string exr_header_fault(const std::filesystem::path& path);

}  // namespace texbake
