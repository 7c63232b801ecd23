#include "cli/bundle_path.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

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

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw Error(ErrorKind::io, fmt::format("{}: {}", path, why));
}

void check_parent_folder(const fs::path& path) {
  fs::path parent = path.has_filename() ? path.parent_path() : path.parent_path().parent_path();
  if (parent.empty()) parent = ".";
  std::error_code ignored;
  if (!fs::is_directory(parent, ignored)) refuse(path, "its folder does not exist; create it first");
  if (access(parent.c_str(), W_OK | X_OK) != 0) refuse(path, "its folder is not writable; check its permissions");
}

}  // namespace

std::string default_bundle_path(const std::string& input) { return stem(input) + kBundleExtension; }

std::string default_picture_path(const std::string& bundle, const std::string& extension) {
  return stem(bundle) + extension;
}

std::string default_web_folder(const std::string& bundle) { return stem(bundle) + "_web"; }

void check_bundle_target(const std::string& path) {
  std::error_code status;
  if (!fs::exists(path, status)) return check_parent_folder(path);
  if (!fs::is_directory(path, status)) refuse(path, "expected a bundle (a folder) or an unused name, found a file");
  const bool is_bundle = fs::exists(fs::path(path) / kManifest, status);
  if (!is_bundle && !fs::is_empty(path, status))
    refuse(path, "expected a bundle or an unused name, found a folder with other content; choose another -o");
  if (access(path.c_str(), W_OK | X_OK) != 0) refuse(path, "the bundle is not writable; check its permissions");
}

void check_file_target(const std::string& path) {
  std::error_code status;
  if (fs::is_directory(path, status)) refuse(path, "expected a file or an unused name, found a folder");
  check_parent_folder(path);
}

}  // namespace texbake
