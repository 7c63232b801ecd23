#include "pages/export_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "formats/safe_file.h"
#include "formats/staged_folder.h"
#include "libbake/base/error.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

bool is_export(const fs::path& folder, const ExportKind& kind) {
  std::string begin(kind.begins.size(), '\0');
  std::ifstream(folder / kind.marker).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == kind.begins;
}

void check_export_folder(const fs::path& folder, const ExportKind& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return;
  const auto refuse = [&](const std::string& found) {
    throw Error(ErrorKind::io,
                fmt::format("{}: expected a new folder or one that an earlier export made, found {}: give "
                            "another -o",
                            folder.string(), found));
  };
  if (!fs::is_directory(status)) refuse("a file");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool ours = kind.may_own(name) && is_export(folder, kind);
    if (!ours && !is_temporary_name(name)) refuse(fmt::format("\"{}\" in it", name));
  }
}

}  // namespace

void write_export(const fs::path& target, const ExportKind& kind,
                  const std::function<void(const fs::path& folder)>& write) {
  check_export_folder(target, kind);
  const fs::path folder = with_folder(target);
  std::error_code error;
  if (fs::is_directory(folder, error)) return write(folder);
  // The first folder of the path that is missing appears as a whole, with those below it.
  fs::path first = folder;
  while (first.parent_path().has_filename() && !fs::exists(first.parent_path(), error)) first = first.parent_path();
  StagedFolder staging(first);
  const fs::path filled = (staging.path() / folder.lexically_relative(first)).lexically_normal();
  fs::create_directories(filled, error);
  if (error) throw Error(ErrorKind::io, fmt::format("{}: cannot be made: {}", target.string(), error.message()));
  write(filled);
  staging.commit();
}

}  // namespace texbake
