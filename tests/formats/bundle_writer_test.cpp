// What is left of a bundle when its writer fails or is killed: the old one or the new one, whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "formats/verify.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr float kOld = 0.5f;
constexpr float kNew = 0.25f;

pid_t start_writer(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), KILLED_WRITER);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  EXPECT_EQ(posix_spawn(&child, KILLED_WRITER, nullptr, nullptr, pointers.data(), environ), 0);
  return child;
}

/// True when the child ended by itself, false when a signal ended it.
bool wait_for(pid_t child) {
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(!WIFEXITED(status) || WEXITSTATUS(status) == 0);
  return WIFEXITED(status);
}

float mark_of(const fs::path& bundle) { return (*read_bundle(bundle).scales[0].height)(0, 0); }

TEST(BundleWriter, KilledBeforeAnyStepItLeavesTheOldBundleOrTheNew) {
  bool done = false;
  bool seen_old = false, seen_new = false;
  for (int step = 0; !done; ++step) {
    SCOPED_TRACE(step);
    const TemporaryFolder folder;
    const fs::path bundle = folder / "a.texbundle";
    write_bundle(bundle_with_everything(kOld), bundle);
    done = wait_for(start_writer({bundle.string(), "0.25", std::to_string(step)}));
    const float mark = mark_of(bundle);
    EXPECT_TRUE(mark == kOld || mark == kNew);
    seen_old |= mark == kOld;
    seen_new |= mark == kNew;
    // The next writer leaves no trace of the dead one.
    write_bundle(bundle_with_everything(kNew), bundle);
    EXPECT_EQ(mark_of(bundle), kNew);
    EXPECT_EQ(folder_contents(bundle).size(), 4u);
    EXPECT_EQ(folder_contents(folder.path()).size(), 1u);
  }
  EXPECT_TRUE(seen_old && seen_new);
}

TEST(BundleWriter, KilledWhileItMakesANewBundleItLeavesNoneOrTheWhole) {
  bool done = false;
  for (int step = 0; !done; ++step) {
    SCOPED_TRACE(step);
    const TemporaryFolder folder;
    const fs::path bundle = folder / "a.texbundle";
    done = wait_for(start_writer({bundle.string(), "0.25", std::to_string(step)}));
    EXPECT_TRUE(!fs::exists(bundle) || mark_of(bundle) == kNew);
    write_bundle(bundle_with_everything(kNew), bundle);
    EXPECT_TRUE(verify_bundle(bundle).empty());
    if (!done) write_bundle(bundle_with_everything(kNew), folder / "b.texbundle");
    fs::remove_all(folder / "b.texbundle");
    EXPECT_EQ(folder_contents(folder.path()).size(), 1u);
  }
}

TEST(BundleWriter, KilledAtAnyMomentItLeavesAWholeBundle) {
  const TemporaryFolder folder;
  const fs::path bundle = folder / "a.texbundle";
  write_bundle(bundle_with_everything(kOld), bundle);
  Random random(7);
  for (int round = 0; round < 12; ++round) {
    const pid_t writer = start_writer({bundle.string()});
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + random.below(150)));
    ::kill(writer, SIGKILL);
    EXPECT_FALSE(wait_for(writer));
    const float mark = mark_of(bundle);
    EXPECT_TRUE(mark == kOld || mark == 0.25f || mark == 0.75f) << mark;
  }
  write_bundle(bundle_with_everything(kOld), bundle);
  EXPECT_EQ(folder_contents(bundle).size(), 4u);
}

TEST(BundleWriter, AReaderBesideAWriterSeesTheOldBundleOrTheNew) {
  const TemporaryFolder folder;
  const fs::path bundle = folder / "a.texbundle";
  write_bundle(bundle_with_everything(kOld), bundle);
  const pid_t writer = start_writer({bundle.string()});
  for (int round = 0; round < 25; ++round) {
    const float mark = mark_of(bundle);
    EXPECT_TRUE(mark == kOld || mark == 0.25f || mark == 0.75f) << mark;
  }
  ::kill(writer, SIGKILL);
  wait_for(writer);
}

/// What a step that the system refuses looks like.
struct RefuseAt {
  int step;
  int seen = 0;
  void operator()(std::string_view name) {
    if (seen++ == step) throw Error(ErrorKind::io, "expected room, found none, at " + std::string(name));
  }
};

TEST(BundleWriter, AStepThatFailsLeavesNothingBehind) {
  bool done = false;
  for (int step = 0; !done; ++step) {
    SCOPED_TRACE(step);
    const TemporaryFolder folder;
    const fs::path bundle = folder / "a.texbundle";
    write_bundle(bundle_with_everything(kOld), bundle);
    const auto before = folder_contents(bundle);
    try {
      write_bundle(bundle_with_everything(kNew), bundle, {.hook = RefuseAt{step}});
      done = true;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::io);
    }
    const float mark = mark_of(bundle);
    EXPECT_TRUE(mark == kOld || mark == kNew);
    for (const auto& [name, bytes] : folder_contents(bundle)) EXPECT_FALSE(name.starts_with('.')) << name;
    if (mark == kOld) {
      EXPECT_EQ(folder_contents(bundle), before);
    }
    EXPECT_EQ(folder_contents(folder.path()).size(), 1u);
  }
}

TEST(BundleWriter, AStepThatFailsOnANewBundleLeavesNoneOrTheWhole) {
  bool done = false;
  for (int step = 0; !done; ++step) {
    SCOPED_TRACE(step);
    const TemporaryFolder folder;
    try {
      write_bundle(bundle_with_everything(kNew), folder / "a.texbundle", {.hook = RefuseAt{step}});
      done = true;
    } catch (const Error&) {
    }
    const auto left = folder_contents(folder.path());
    EXPECT_LE(left.size(), 1u);
    EXPECT_TRUE(left.empty() || mark_of(folder / "a.texbundle") == kNew);
  }
}

TEST(BundleWriter, TwoWritersAtOnceDoNotMix) {
  const TemporaryFolder folder;
  const fs::path bundle = folder / "a.texbundle";
  write_bundle(bundle_with_everything(kOld), bundle);
  const auto write_inside = [&](std::string_view step) {
    if (step != "write bundle.json") return;
    EXPECT_THROW(write_bundle(bundle_with_everything(0.75f), bundle), Error);
  };
  write_bundle(bundle_with_everything(kNew), bundle, {.hook = write_inside});
  EXPECT_EQ(mark_of(bundle), kNew);
  EXPECT_EQ(folder_contents(bundle).size(), 4u);
}

}  // namespace
}  // namespace texbake
