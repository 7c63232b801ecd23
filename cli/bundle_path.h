// Where a verb's output goes, checked before the work is done and not after.
#pragma once

#include <string>

namespace texbake {

inline constexpr const char* kBundleExtension = ".texbundle";

/// The path a bundle of `input` gets when none is given: `leaves.texbundle` in the working folder for `dir/leaves.jpg`.
std::string default_bundle_path(const std::string& input);
/// `leaves_render.png` in the working folder for `dir/leaves.texbundle`: `leaves.png` may be the photograph.
std::string default_picture_path(const std::string& bundle);
/// `leaves_web` in the working folder for `dir/leaves.texbundle`.
std::string default_web_folder(const std::string& bundle);
/// `leaves_planes` in the working folder for `dir/leaves.texbundle`.
std::string default_planes_folder(const std::string& bundle);

/// Throw Error(io) when something stands at `path` that is not a bundle (not a file), or its folder cannot be written;
/// Error(usage) for a bundle that is called like a picture or a page, and for a file in a bundle.
void check_bundle_target(const std::string& path);
void check_file_target(const std::string& path);

/// Throws Error(usage) unless `path` is called like a page: NAME.html.
void check_page_name(const std::string& path);

}  // namespace texbake
