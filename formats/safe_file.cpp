#include "formats/safe_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <ctime>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "libbake/base/error.h"

namespace texbake {
namespace {

constexpr std::string_view kTemporarySuffix = ".texbake-tmp-";
constexpr size_t kBufferBytes = 1 << 20;

struct Registry {
  std::mutex mutex;
  std::multiset<std::filesystem::path> paths;
};

Registry& registry() {
  static Registry instance;
  return instance;
}

void remove_quietly(const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

/// Beyond the limit of RLIMIT_FSIZE a write raises SIGXFSZ, which ends the process; blocked, the write fails instead.
class FileSizeSignalBlocked {
 public:
  FileSizeSignalBlocked() {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~FileSizeSignalBlocked() {
    const int saved = errno;
    const timespec at_once{};
    if (!sigismember(&before_, SIGXFSZ)) sigtimedwait(&signal_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = saved;
  }
  FileSizeSignalBlocked(const FileSizeSignalBlocked&) = delete;
  FileSizeSignalBlocked& operator=(const FileSizeSignalBlocked&) = delete;

 private:
  sigset_t signal_{};
  sigset_t before_{};
};

/// write(2) until all bytes are out; false with errno set.
bool write_all(int descriptor, const char* bytes, size_t count) {
  const FileSizeSignalBlocked blocked;
  while (count > 0) {
    const ssize_t written = ::write(descriptor, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<size_t>(written);
  }
  return true;
}

/// Of a plain file; nothing where there is none.
std::optional<struct stat> status_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return status;
}

/// Owner, group and permissions of `status`, as far as this process may give them.
void take_owner(int descriptor, const struct stat& status) {
  constexpr mode_t kEveryone = 0777, kGroup = 0070;
  mode_t mode = status.st_mode & kEveryone;
  if (::fchown(descriptor, status.st_uid, status.st_gid) != 0 &&
      ::fchown(descriptor, static_cast<uid_t>(-1), status.st_gid) != 0)
    mode &= ~kGroup;  // another group must not read what only the old one could
  [[maybe_unused]] const int failed = ::fchmod(descriptor, mode);
}

/// Has the writer of this temporary file ended? It may live on another machine that shares the folder: then its lock
/// tells.
bool is_orphan(const std::filesystem::path& path, std::string_view process) {
  pid_t number = 0;
  const auto [end, error] = std::from_chars(process.data(), process.data() + process.size(), number);
  if (error != std::errc() || number <= 0 || ::kill(number, 0) == 0 || errno != ESRCH) return false;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return false;
  const bool is_free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return is_free;
}

/// Removes what killed writers of `final_path` have left beside it. Failing to tidy up harms nobody.
void remove_orphans(const std::filesystem::path& final_path) {
  const std::string prefix = temporary_prefix(final_path);
  const std::filesystem::path folder = final_path.has_parent_path() ? final_path.parent_path() : ".";
  std::error_code ignored;
  std::vector<std::filesystem::path> orphans;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && is_temporary_name(name) && entry.is_regular_file(ignored) &&
        is_orphan(entry.path(), std::string_view(name).substr(prefix.size())))
      orphans.push_back(entry.path());
  }
  for (const std::filesystem::path& orphan : orphans) std::filesystem::remove(orphan, ignored);
}

}  // namespace

Unfinished::Unfinished(std::filesystem::path path) : path_(std::move(path)) {
  const std::lock_guard lock(registry().mutex);
  registry().paths.insert(path_);
}

void Unfinished::release() {
  if (released_) return;
  released_ = true;
  const std::lock_guard lock(registry().mutex);
  registry().paths.erase(registry().paths.find(path_));
}

Unfinished::~Unfinished() {
  if (released_) return;
  remove_quietly(path_);
  release();
}

void remove_all_unfinished() {
  const std::lock_guard lock(registry().mutex);
  for (const std::filesystem::path& path : registry().paths) remove_quietly(path);
}

SafeFile::SafeFile(std::filesystem::path final_path, StepHook hook, const std::filesystem::path& like)
    : final_path_(std::move(final_path)), hook_(std::move(hook)), unfinished_(temporary_beside(final_path_)) {
  if (hook_) hook_(fmt::format("create {}", final_path_.filename().string()));
  const std::optional<struct stat> owned = status_of(like.empty() ? final_path_ : like);
  constexpr mode_t kNobodyElse = 0600, kAsUserSays = 0666;
  descriptor_ = ::open(unfinished_.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW,
                       owned ? kNobodyElse : kAsUserSays);
  if (descriptor_ < 0) fail("create");
  ::flock(descriptor_, LOCK_EX | LOCK_NB);  // what is locked is not taken for an orphan; not every disk has locks
  remove_orphans(final_path_);
  if (owned) take_owner(descriptor_, *owned);
  buffer_.reserve(kBufferBytes);
}

SafeFile::~SafeFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void SafeFile::fail(const char* step) const {
  throw Error(ErrorKind::io, fmt::format("{}: could not {} the file: {}; free some space or choose another location",
                                         final_path_.string(), step, std::strerror(errno)));
}

void SafeFile::write(const void* bytes, size_t count) {
  const char* from = static_cast<const char*>(bytes);
  while (count > 0) {
    const size_t part = std::min(count, kBufferBytes - buffer_.size());
    buffer_.insert(buffer_.end(), from, from + part);
    from += part;
    count -= part;
    if (buffer_.size() == kBufferBytes) flush();
  }
}

void SafeFile::flush() {
  if (!write_all(descriptor_, buffer_.data(), buffer_.size())) fail("write");
  position_ += buffer_.size();
  buffer_.clear();
}

void SafeFile::seek(uint64_t position) {
  flush();
  if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail("write");
  position_ = position;
}

void SafeFile::commit() {
  const std::string name = final_path_.filename().string();
  if (hook_) hook_(fmt::format("sync {}", name));
  flush();
  if (::fsync(descriptor_) != 0) fail("write");
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("write");
  if (hook_) hook_(fmt::format("rename {}", name));
  if (::rename(unfinished_.path().c_str(), final_path_.c_str()) != 0) fail("replace");
  unfinished_.release();
  if (hook_) hook_(fmt::format("renamed {}", name));
  sync_folder(final_path_.parent_path());
}

void sync_folder(const std::filesystem::path& folder) {
  const std::string name = folder.empty() ? "." : folder.string();
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // A folder that may be written to but not read has no descriptor to be synchronized by.
  const bool synced = descriptor >= 0 ? ::fsync(descriptor) == 0 || errno == EINVAL : errno == EACCES;
  const int reason = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!synced)
    throw Error(ErrorKind::io, fmt::format("{}: could not flush the folder to disk: {}", name, std::strerror(reason)));
}

std::string temporary_prefix(const std::filesystem::path& final_path) {
  return fmt::format(".{}{}", final_path.filename().string(), kTemporarySuffix);
}

std::filesystem::path temporary_beside(const std::filesystem::path& final_path) {
  return final_path.parent_path() / fmt::format("{}{}", temporary_prefix(final_path), ::getpid());
}

bool is_temporary_name(std::string_view file_name) {
  const size_t at = file_name.rfind(kTemporarySuffix);
  if (file_name.empty() || file_name.front() != '.' || at == std::string_view::npos) return false;
  const std::string_view number = file_name.substr(at + kTemporarySuffix.size());
  return !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace texbake
