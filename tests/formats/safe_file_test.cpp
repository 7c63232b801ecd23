#include "formats/safe_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <fstream>

#include "libbake/base/error.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

/// What is told of the calls that bring bytes and names to the disk, in this program, while it lives.
class DiskWatch {
 public:
  DiskWatch() { current = this; }
  ~DiskWatch() { current = nullptr; }
  DiskWatch(const DiskWatch&) = delete;
  DiskWatch& operator=(const DiskWatch&) = delete;

  static inline DiskWatch* current = nullptr;
  std::vector<std::string> calls;  ///< "sync PATH (BYTES)", "sync PATH/", "rename PATH"
  std::string fails;               ///< a call that begins like this fails; "": none
  int fails_at = -1;               ///< the call of this number fails, of all kinds; −1: none
  int reason = EIO;                ///< errno of a call that fails
  int count = 0;                   ///< of calls, with those to create and to write, which are not noted
};

/// False where a call is to fail.
bool count_call() {
  DiskWatch* watch = DiskWatch::current;
  if (!watch || watch->count++ != watch->fails_at) return true;
  errno = watch->reason;
  return false;
}

/// Notes the call; false where it is to fail.
bool note_call(const std::string& call) {
  DiskWatch* watch = DiskWatch::current;
  if (!watch) return true;
  watch->calls.push_back(call);
  if (!watch->fails.empty() && call.starts_with(watch->fails)) {
    errno = watch->reason;
    return false;
  }
  return count_call();
}

std::string sync_text(int descriptor) {
  std::error_code ignored;
  const fs::path path = fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor), ignored);
  if (fs::is_directory(path, ignored)) return "sync " + path.string() + "/";
  return "sync " + path.string() + " (" + std::to_string(fs::file_size(path, ignored)) + ")";
}

}  // namespace
}  // namespace texbake

// The program's own, in place of the C library's: they note the call and make it.
extern "C" int fsync(int descriptor) {
  if (!texbake::note_call(texbake::sync_text(descriptor))) return -1;
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}
extern "C" int rename(const char* from, const char* to) noexcept {
  if (!texbake::note_call(std::string("rename ") + to)) return -1;
  return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0u));
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
  return texbake::count_call() ? syscall(SYS_write, descriptor, bytes, count) : -1;
}
extern "C" int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if ((flags & O_CREAT) != 0 && !texbake::count_call()) return -1;
  return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
extern "C" int mkdir(const char* path, mode_t mode) noexcept {
  return texbake::count_call() ? static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode)) : -1;
}

namespace texbake {
namespace {

/// No file may grow beyond `bytes` while this lives: what a full disk looks like to the writer.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

template <class Action>
void expect_io_error(const Action& action) {
  try {
    action();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::io);
    EXPECT_THAT(error.what(), testing::HasSubstr("could not"));
  }
}

TEST(SafeFile, TheNameShowsTheOldContentUntilCommit) {
  const TemporaryFolder folder;
  write_text(folder / "a", "old");
  SafeFile file(folder / "a");
  file.write("new");
  EXPECT_EQ(file_text(folder / "a"), "old");
  file.commit();
  EXPECT_EQ(file_text(folder / "a"), "new");
  EXPECT_EQ(folder_contents(folder.path()).size(), 1u);
}

/// The call without the path of `folder`.
std::string without_folder(const std::string& call, const fs::path& folder) {
  const size_t at = call.find(folder.string());
  return at == std::string::npos ? call : call.substr(0, at) + call.substr(at + folder.string().size());
}

TEST(SafeFile, BytesAreOnTheDiskBeforeTheirNameAndTheNameBeforeCommitReturns) {
  const TemporaryFolder folder;
  DiskWatch watch;
  SafeFile file(folder / "a");
  const std::string temporary = file.temporary_path().filename().string();
  file.write(std::string(5000, 'x'));
  file.commit();
  std::vector<std::string> calls;
  for (const std::string& call : watch.calls) calls.push_back(without_folder(call, folder.path()));
  EXPECT_THAT(calls, testing::ElementsAre("sync /" + temporary + " (5000)", "rename /a", "sync /"));
}

TEST(SafeFile, BytesThatDoNotReachTheDiskAreAnIoErrorThatLeavesTheOldFile) {
  const TemporaryFolder folder;
  write_text(folder / "a", "old");
  {
    DiskWatch watch;
    watch.fails = "sync ";
    expect_io_error([&] {
      SafeFile file(folder / "a");
      file.write("new");
      file.commit();
    });
    EXPECT_EQ(watch.calls.size(), 1u) << "nothing is named that is not there";
  }
  EXPECT_EQ(folder_contents(folder.path()), (std::map<std::string, std::string>{{"a", "old"}}));
}

TEST(SafeFile, ANameThatDoesNotReachTheDiskIsAnIoError) {
  const TemporaryFolder folder;
  DiskWatch watch;
  watch.fails = "sync " + folder.path().string() + "/";
  expect_io_error([&] { sync_folder(folder.path()); });
}

TEST(SafeFile, ANewBundleIsOnTheDiskBeforeItHasItsName) {
  const TemporaryFolder folder;
  DiskWatch watch;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  std::vector<std::string> named;  // since the last sync of a folder
  std::string synced;
  for (const std::string& call : watch.calls) {
    if (call.starts_with("rename ")) named.push_back(call.substr(7));
    if (call.ends_with("/")) named.clear(), synced = call.substr(5);
    if (call == "rename " + (folder / "a.texbundle").string()) {
      EXPECT_EQ(named.size(), 1u) << "every file in the folder was brought to the disk before";
      EXPECT_THAT(synced, testing::HasSubstr("/.a.texbundle.texbake-tmp-"));
    }
  }
  EXPECT_THAT(named, testing::IsEmpty());
  EXPECT_EQ(synced, folder.path().string() + "/");
}

/// Makes the call of each number fail once, for each of the reasons for which disks refuse, until `action` gets by
/// without that call. `check` looks at what is left.
template <class Action, class Check>
void fail_each_call_once(const Action& action, const Check& check) {
  for (const int reason : {ENOSPC, EDQUOT, EIO}) {
    bool failed = true;
    int number = 0;
    for (; failed && number < 1000; ++number) {
      SCOPED_TRACE(std::to_string(number) + ": " + std::strerror(reason));
      {
        DiskWatch watch;
        watch.fails_at = number;
        watch.reason = reason;
        try {
          action();
        } catch (const Error& error) {
          EXPECT_EQ(error.kind(), ErrorKind::io) << error.what();
        }
        failed = watch.count > number;
      }
      check();
    }
    EXPECT_GT(number, 3) << "calls were counted";
  }
}

/// Without noises, whose tiles are large.
Bundle small_bundle(float mark) {
  Bundle bundle = bundle_with_everything(mark, 16);
  bundle.noise.reset();
  return bundle;
}

TEST(SafeFile, AnyCallThatFailsLeavesTheOldOrTheNewBundle) {
  const TemporaryFolder folder;
  const Bundle one = small_bundle(0.25f), other = small_bundle(0.75f);
  bool is_one = true;
  write_bundle(one, folder / "a.texbundle");
  fail_each_call_once([&] { write_bundle(is_one ? other : one, folder / "a.texbundle"); },
                      [&] {
                        const float mark = read_bundle(folder / "a.texbundle").scales[0].height->operator()(0, 0);
                        EXPECT_TRUE(mark == 0.25f || mark == 0.75f);
                        is_one = mark == 0.25f;
                        EXPECT_EQ(folder_contents(folder.path()).size(), 1u);
                        for (const auto& [name, text] : folder_contents(folder / "a.texbundle"))
                          EXPECT_FALSE(is_temporary_name(name)) << name;
                      });
}

TEST(SafeFile, AnyCallThatFailsLeavesNoBundleOrAWholeOne) {
  const TemporaryFolder folder;
  const Bundle bundle = small_bundle(0.25f);
  fail_each_call_once([&] { write_bundle(bundle, folder / "a.texbundle"); },
                      [&] {
                        if (fs::exists(folder / "a.texbundle")) read_bundle(folder / "a.texbundle");
                        fs::remove_all(folder / "a.texbundle");
                        EXPECT_TRUE(fs::is_empty(folder.path()));
                      });
}

TEST(SafeFile, AnyCallThatFailsLeavesTheOldOrTheNewFile) {
  const TemporaryFolder folder;
  const std::string large(3 << 20, 'x');
  write_text(folder / "a", "old");
  fail_each_call_once(
      [&] {
        SafeFile file(folder / "a");
        file.write(large);
        file.seek(5);
        file.write("middle");
        file.commit();
      },
      [&] {
        const auto left = folder_contents(folder.path());
        ASSERT_EQ(left.size(), 1u);
        EXPECT_TRUE(left.at("a") == "old" || left.at("a").size() == large.size());
        write_text(folder / "a", "old");
      });
}

TEST(SafeFile, WhatAKilledWriterLeftIsRemovedByTheNext) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);  // its number is nobody's now
  const std::string dead = ".a.texbake-tmp-" + std::to_string(child);
  const std::string alive = ".a.texbake-tmp-" + std::to_string(::getppid());
  for (const std::string& name : {dead, alive, ".b.texbake-tmp-" + std::to_string(child), dead + "x"})
    write_text(folder / name, "half");
  SafeFile file(folder / "a");
  file.write("new");
  file.commit();
  const auto left = folder_contents(folder.path());
  EXPECT_FALSE(left.contains(dead));
  EXPECT_TRUE(left.contains(alive)) << "its writer may still be at work";
  EXPECT_EQ(left.size(), 4u) << "other files are nobody's business";
}

TEST(SafeFile, WithoutCommitNothingStays) {
  const TemporaryFolder folder;
  {
    SafeFile file(folder / "a");
    file.write(std::string(3 << 20, 'x'));
    EXPECT_TRUE(is_temporary_name(file.temporary_path().filename().string()));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

/// The permissions of the file, as chmod(1) takes them.
unsigned mode_of(const fs::path& path) { return static_cast<unsigned>(fs::status(path).permissions()); }

TEST(SafeFile, WhatTakesThePlaceOfAFileMayBeReadByTheSamePeople) {
  const TemporaryFolder folder;
  for (const unsigned mode : {0640u, 0600u, 0664u, 0444u}) {
    write_text(folder / "a", "old");
    fs::permissions(folder / "a", static_cast<fs::perms>(mode));
    SafeFile file(folder / "a");
    EXPECT_EQ(mode_of(file.temporary_path()), mode);
    file.commit();
    EXPECT_EQ(mode_of(folder / "a"), mode);
    SafeFile other(folder / "b", {}, folder / "a");
    other.commit();
    EXPECT_EQ(mode_of(folder / "b"), mode);
    fs::remove(folder / "a");
    fs::remove(folder / "b");
  }
}

TEST(SafeFile, ANewFileIsAsTheUserWantsNewFiles) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(0027);
  SafeFile file(folder / "a", {}, folder / "none");
  ::umask(before);
  file.commit();
  EXPECT_EQ(mode_of(folder / "a"), 0640u);
}

TEST(SafeFile, SeekingBackPatchesWhatWasWritten) {
  const TemporaryFolder folder;
  SafeFile file(folder / "a");
  file.write("head....");
  file.write(std::string(2 << 20, 'x'));
  const uint64_t end = file.position();
  file.seek(4);
  file.write("1234");
  file.seek(end);
  file.write("tail");
  file.commit();
  EXPECT_EQ(file_text(folder / "a"), "head1234" + std::string(2 << 20, 'x') + "tail");
}

TEST(SafeFile, AFullDiskIsAnIoErrorThatLeavesTheOldFile) {
  const TemporaryFolder folder;
  write_text(folder / "a", "old");
  {
    const FileSizeLimit limit(1000);
    expect_io_error([&] {
      SafeFile file(folder / "a");
      file.write(std::string(5000, 'x'));
      file.commit();
    });
  }
  EXPECT_EQ(folder_contents(folder.path()), (std::map<std::string, std::string>{{"a", "old"}}));
}

TEST(SafeFile, AFolderThatCannotBeWrittenIsAnIoError) {
  expect_io_error([] { SafeFile("/proc/self/texbake"); });
  expect_io_error([] { SafeFile("/nonexistent/texbake"); });
}

TEST(SafeFile, AFolderIsNeverReplacedByAFile) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a");
  expect_io_error([&] {
    SafeFile file(folder / "a");
    file.write("x");
    file.commit();
  });
  EXPECT_THAT(folder_contents(folder.path()), testing::ElementsAre(testing::Key("a")));
}

TEST(SafeFile, WhatIsUnfinishedCanBeRemovedAtOnce) {
  const TemporaryFolder folder;
  SafeFile file(folder / "a");
  fs::create_directory(folder / "staging");
  write_text(folder / "staging/b", "x");
  const Unfinished staging(folder / "staging");
  remove_all_unfinished();
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(SafeFile, OnlyItsOwnTemporaryNamesAreRecognised) {
  EXPECT_TRUE(is_temporary_name(".bundle.json.texbake-tmp-123"));
  for (const char* name : {"bundle.json", ".hidden", ".x.texbake-tmp-", ".x.texbake-tmp-12a", "x.texbake-tmp-12", ""})
    EXPECT_FALSE(is_temporary_name(name)) << name;
}

TEST(SafeFile, ABundleThatDoesNotFitLeavesTheOldOne) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(0.5f), folder / "a.texbundle");
  const auto before = folder_contents(folder / "a.texbundle");
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{5000}, rlim_t{20000}}) {
    const FileSizeLimit limit(bytes);
    expect_io_error([&] { write_bundle(bundle_with_everything(0.25f), folder / "a.texbundle"); });
    expect_io_error([&] { write_bundle(bundle_with_everything(0.25f), folder / "b.texbundle"); });
    EXPECT_EQ(folder_contents(folder / "a.texbundle"), before) << bytes;
    EXPECT_EQ(folder_contents(folder.path()).size(), 1u) << bytes;
  }
}

}  // namespace
}  // namespace texbake
