#include "formats/staged_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "libbake/base/error.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

TEST(StagedFolder, ItAppearsWithAllThatIsInIt) {
  const TemporaryFolder folder;
  StagedFolder staged(folder / "a");
  write_text(staged.path() / "x", "text");
  EXPECT_FALSE(fs::exists(folder / "a"));
  staged.commit();
  EXPECT_EQ(file_text(folder / "a/x"), "text");
  EXPECT_EQ(folder_contents(folder.path()).size(), 1u);
}

TEST(StagedFolder, WithoutCommitNothingStays) {
  const TemporaryFolder folder;
  {
    const StagedFolder staged(folder / "a");
    write_text(staged.path() / "x", "text");
  }
  EXPECT_THAT(folder_contents(folder.path()), testing::IsEmpty());
}

TEST(StagedFolder, OnlyAnEmptyFolderIsReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a");
  StagedFolder first(folder / "a");
  first.commit();
  write_text(folder / "a/x", "text");
  StagedFolder second(folder / "a");
  EXPECT_THROW(second.commit(), Error);
  EXPECT_EQ(file_text(folder / "a/x"), "text");
}

TEST(StagedFolder, WhatKilledWritersOfTheNameLeftIsRemovedAndNothingElse) {
  const TemporaryFolder folder;
  for (const char* name : {".a.texbake-tmp-1", ".b.texbake-tmp-1", ".a.texbake-tmp-notes", "a.texbake-tmp-1"})
    fs::create_directory(folder / name);
  StagedFolder staged(folder / "a");
  staged.commit();
  const auto left = folder_contents(folder.path());
  EXPECT_FALSE(left.contains(".a.texbake-tmp-1"));
  EXPECT_EQ(left.size(), 4u);
}

TEST(StagedFolder, AFolderThatAnotherWriterHasIsLeftToIt) {
  const TemporaryFolder folder;
  fs::create_directory(folder / ".a.texbake-tmp-1");
  {
    const FolderLock other(folder / ".a.texbake-tmp-1");
    EXPECT_TRUE(other);
    EXPECT_FALSE(FolderLock(folder / ".a.texbake-tmp-1"));
    const StagedFolder staged(folder / "a");
    EXPECT_TRUE(fs::exists(folder / ".a.texbake-tmp-1"));
  }
  EXPECT_TRUE(FolderLock(folder / ".a.texbake-tmp-1"));
}

TEST(StagedFolder, APathHasAFolderInFrontAndNoSlashBehind) {
  EXPECT_EQ(with_folder("a"), "./a");
  EXPECT_EQ(with_folder("a/"), "./a");
  EXPECT_EQ(with_folder("b/../c/a//"), "c/a");
  EXPECT_EQ(with_folder("/a"), "/a");
}

}  // namespace
}  // namespace texbake
