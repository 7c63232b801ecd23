// What is fuzzed: readers of files that strangers hand over. Each target runs under libFuzzer (tests/fuzz/run.sh, for
// hours) and in the tests (smoke.cpp, a fixed number of executions).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "libbake/base/random.h"

namespace texbake::fuzz {

struct Target {
  const char* name;
  /// Small inputs that are sound, to begin with.
  std::vector<std::string> (*seeds)();
  /// Another input, mostly of the same form.
  std::string (*mutate)(const std::string& input, Random& random);
  /// Reads `input`. Throws nothing; anything but a message of the program is a crash.
  void (*run)(const std::string& input);
};

/// All targets.
const std::vector<Target>& targets();
/// The one of that name. Ends the process when there is none.
const Target& target(std::string_view name);

extern const Target kManifest, kBundle, kClicks, kRecipe, kCamera, kPicture;

/// A folder of this process, in memory where there is some, for readers that want files.
const std::filesystem::path& scratch();
void write_file(const std::filesystem::path& path, std::string_view bytes);
std::string read_file(const std::filesystem::path& path);

/// Bits flipped, bytes replaced, runs removed, doubled or moved.
std::string mutate_bytes(std::string bytes, Random& random);

/// Ends the process: a law that holds for every input does not hold.
[[noreturn]] void broken(const std::string& law);

}  // namespace texbake::fuzz
