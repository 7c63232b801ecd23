// Writes a file so that its name only ever shows the whole old or the whole new content: aside, checked, synchronized,
// renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texbake {

/// Called before each step that changes the file system ("write bundle.json", "rename bundle.json", ...). Tests throw
/// or kill the process here. Empty otherwise.
using StepHook = std::function<void(std::string_view step)>;

/// Something half written on the disk: removed with everything below it when this goes out of scope, unless released.
class Unfinished {
 public:
  explicit Unfinished(std::filesystem::path path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void release();

 private:
  std::filesystem::path path_;
  bool released_ = false;
};

/// Removes everything unfinished of this process: what a program does when it is told to stop. Any thread may call it,
/// a signal handler may not; the process must end afterwards.
void remove_all_unfinished();

/// A file under a temporary name in the folder of `final_path`, until `commit`. Every failure (no permission, full
/// disk, file size limit) throws Error(io); what was at `final_path` before stays as it was. Who may read and write the
/// file is as for the file `like` (by default, the one that is replaced), where there is one.
class SafeFile {
 public:
  explicit SafeFile(std::filesystem::path final_path, StepHook hook = {}, const std::filesystem::path& like = {});
  ~SafeFile();
  SafeFile(const SafeFile&) = delete;
  SafeFile& operator=(const SafeFile&) = delete;

  void write(const void* bytes, size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Offset of the next byte; `seek` may go back to patch what was written.
  uint64_t position() const { return position_ + buffer_.size(); }
  void seek(uint64_t position);
  /// Where the bytes are until `commit`, for libraries that write by name: they may truncate it, not replace it.
  const std::filesystem::path& temporary_path() const { return unfinished_.path(); }
  /// Brings the bytes to the disk and gives them their name. Nothing may be written afterwards.
  void commit();

 private:
  void flush();
  [[noreturn]] void fail(const char* step) const;

  std::filesystem::path final_path_;
  StepHook hook_;
  Unfinished unfinished_;
  int descriptor_ = -1;
  uint64_t position_ = 0;
  std::vector<char> buffer_;
};

/// Brings a folder's list of names to the disk, where the folder may be read. Throws Error(io).
void sync_folder(const std::filesystem::path& folder);

/// What the name of a temporary file or folder for `final_path` begins with; the number of the process follows.
std::string temporary_prefix(const std::filesystem::path& final_path);
/// The whole of that name, for this process, in the folder of `final_path`.
std::filesystem::path temporary_beside(const std::filesystem::path& final_path);

/// True for the name of a temporary file that a killed `SafeFile` may have left behind.
bool is_temporary_name(std::string_view file_name);

}  // namespace texbake
