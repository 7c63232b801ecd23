// Makes a folder so that its name only ever shows all that is to be in it: aside, filled, renamed.
#pragma once

#include <filesystem>

#include "formats/safe_file.h"

namespace texbake {

/// `path` without a slash at the end, and with a folder in front, if only ".".
std::filesystem::path with_folder(std::filesystem::path path);

/// A folder that one writer has for itself. The kernel frees it when the writer ends, however it ends. File systems
/// without locks, and folders that may not be read, are written without: two writers at once are then the user's care.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  /// False while another writer has the folder.
  explicit operator bool() const { return locked_; }

 private:
  int descriptor_;
  bool locked_ = false;
};

/// A folder under a temporary name beside `final_path`, until `commit`; removed with all that is in it when it is
/// destroyed before. Every failure throws Error(io). What killed writers of the same name left is removed first.
class StagedFolder {
 public:
  /// `final_path` is as with_folder makes it.
  explicit StagedFolder(std::filesystem::path final_path, StepHook hook = {});

  const std::filesystem::path& path() const { return unfinished_.path(); }
  /// Gives the folder its name, which may be that of an empty folder.
  void commit();

 private:
  std::filesystem::path final_path_;
  StepHook hook_;
  Unfinished unfinished_;
  FolderLock lock_;
};

}  // namespace texbake
