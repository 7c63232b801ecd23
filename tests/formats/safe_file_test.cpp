#include "formats/safe_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>

#include "libbake/base/error.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

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
    EXPECT_THAT(error.what(), testing::HasSubstr("expected"));
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

TEST(SafeFile, WithoutCommitNothingStays) {
  const TemporaryFolder folder;
  {
    SafeFile file(folder / "a");
    file.write(std::string(3 << 20, 'x'));
    EXPECT_TRUE(is_temporary_name(file.temporary_path().filename().string()));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
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
