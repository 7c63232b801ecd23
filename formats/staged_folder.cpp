#include "formats/staged_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "libbake/base/error.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

Error folder_failure(const fs::path& path, const char* action) {
  return Error(ErrorKind::io, fmt::format("{}: could not {} the folder: {}; choose a writable location", path.string(),
                                          action, std::strerror(errno)));
}

/// Staging folders of writers of `path` that no longer live.
void remove_dead_staging(const fs::path& path) {
  std::error_code ignored;
  std::vector<fs::path> dead;
  for (const auto& entry : fs::directory_iterator(path.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(temporary_prefix(path)) && is_temporary_name(name) && entry.is_directory(ignored) &&
        FolderLock(entry.path()))
      dead.push_back(entry.path());
  }
  for (const fs::path& folder : dead) fs::remove_all(folder, ignored);
}

/// Makes the temporary folder, and returns its path.
fs::path made_staging(const fs::path& final_path, const StepHook& hook) {
  remove_dead_staging(final_path);
  fs::path path = temporary_beside(final_path);
  if (hook) hook("create folder");
  if (::mkdir(path.c_str(), 0777) != 0) throw folder_failure(final_path, "create");
  return path;
}

}  // namespace

fs::path with_folder(fs::path path) {
  path = path.lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return path.has_parent_path() ? path : fs::path(".") / path;
}

FolderLock::FolderLock(const fs::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  locked_ = descriptor_ >= 0 ? ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK : errno == EACCES;
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

StagedFolder::StagedFolder(fs::path final_path, StepHook hook)
    : final_path_(std::move(final_path)),
      hook_(std::move(hook)),
      unfinished_(made_staging(final_path_, hook_)),
      lock_(unfinished_.path()) {}

void StagedFolder::commit() {
  if (hook_) hook_("rename folder");
  // rename(2) replaces nothing but an empty folder.
  if (::rename(unfinished_.path().c_str(), final_path_.c_str()) != 0) throw folder_failure(final_path_, "rename");
  unfinished_.release();
  if (hook_) hook_("renamed folder");
  sync_folder(final_path_.parent_path());
}

}  // namespace texbake
