#include "cli/bundle_path.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "libbake/base/error.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "bundle.json";

/// The name without folder and last extension; a trailing '/' does not count.
std::string stem(const std::string& path) {
  fs::path clean = fs::path(path).lexically_normal();
  if (!clean.has_filename()) clean = clean.parent_path();
  const std::string name = clean.stem().string();
  return name.empty() || name == "." || name == ".." ? "texture" : name;
}

/// Names that are those of pictures, pages and texts: a folder would be called so by mistake.
constexpr std::string_view kFileExtensions[] = {".png", ".jpg",  ".jpeg", ".tif",  ".tiff", ".exr",
                                                ".hdr", ".html", ".htm",  ".json", ".csv"};

/// The last extension with its dot, in lower case.
std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

/// Throws Error(usage) for a new bundle that would be called like a file.
void check_folder_name(const std::string& path) {
  const std::string extension = extension_of(path);
  if (std::ranges::find(kFileExtensions, extension) != std::end(kFileExtensions))
    throw Error(ErrorKind::usage, fmt::format("{}: expected the name of a bundle, which is a folder NAME{}, found one "
                                              "ending in {}",
                                              path, kBundleExtension, extension));
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw Error(ErrorKind::io, fmt::format("{}: {}", path, why));
}

void check_parent_folder(const fs::path& path) {
  fs::path parent = path.has_filename() ? path.parent_path() : path.parent_path().parent_path();
  if (parent.empty()) parent = ".";
  std::error_code ignored;
  if (!fs::is_directory(parent, ignored)) refuse(path, "its folder does not exist; create it first");
  if (access(parent.c_str(), W_OK | X_OK) != 0)
    refuse(path, fmt::format("its folder cannot be written to: {}; check its permissions", std::strerror(errno)));
}

}  // namespace

std::string default_bundle_path(const std::string& input) { return stem(input) + kBundleExtension; }

std::string default_picture_path(const std::string& bundle) { return stem(bundle) + "_render.png"; }

std::string default_web_folder(const std::string& bundle) { return stem(bundle) + "_web"; }

std::string default_planes_folder(const std::string& bundle) { return stem(bundle) + "_planes"; }

void check_bundle_target(const std::string& path) {
  std::error_code status;
  if (!fs::exists(path, status)) {
    check_folder_name(path);
    return check_parent_folder(path);
  }
  if (!fs::is_directory(path, status)) refuse(path, "expected a bundle (a folder) or an unused name, found a file");
  if (access(path.c_str(), W_OK | X_OK) != 0)
    refuse(path, fmt::format("cannot be written to: {}; check its permissions", std::strerror(errno)));
  const bool is_bundle = fs::exists(fs::path(path) / kManifest, status);
  if (!is_bundle && !fs::is_empty(path, status))
    refuse(path, "expected a bundle or an unused name, found a folder with other content; choose another -o");
}

void check_file_target(const std::string& path) {
  std::error_code status;
  if (fs::is_directory(path, status)) refuse(path, "expected a file or an unused name, found a folder");
  check_parent_folder(path);
  if (fs::exists(fs::path(path).parent_path() / kManifest, status))
    throw Error(ErrorKind::usage,
                fmt::format("{}: expected a name outside a bundle, found a file of one; choose another name", path));
}

void check_page_name(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension != ".html" && extension != ".htm")
    throw Error(ErrorKind::usage, fmt::format("{}: expected the name of a page, ending in .html, found {}", path,
                                              extension.empty() ? "no extension" : extension));
}

}  // namespace texbake
