#include "tests/fuzz/target.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace texbake::fuzz {

namespace fs = std::filesystem;

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {kManifest, kBundle, kClicks, kRecipe, kCamera, kPicture};
  return all;
}

const Target& target(std::string_view name) {
  for (const Target& one : targets())
    if (name == one.name) return one;
  std::fprintf(stderr, "no target %.*s\n", static_cast<int>(name.size()), name.data());
  std::exit(2);
}

namespace {

struct Scratch {
  fs::path path;
  Scratch() {
    const bool has_memory = fs::is_directory("/dev/shm");
    path = (has_memory ? fs::path("/dev/shm") : fs::temp_directory_path()) /
           ("texbake-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(path);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

}  // namespace

const fs::path& scratch() {
  static const Scratch folder;
  return folder.path;
}

void write_file(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string read_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string mutate_bytes(std::string bytes, Random& random) {
  const auto place = [&] { return random.below(static_cast<uint32_t>(bytes.size())); };
  for (uint32_t round = 0; round <= random.below(4); ++round) {
    if (bytes.empty()) bytes = "\n";
    const size_t at = place();
    const size_t count = std::min<size_t>(1 + random.below(16), bytes.size() - at);
    switch (random.below(6)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 2:
        bytes.erase(at, count);
        break;
      case 3:
        bytes.insert(place(), bytes.substr(at, count));
        break;
      case 4:
        std::fill_n(bytes.begin() + static_cast<ptrdiff_t>(at), count, random.below(2) ? '\xff' : '\0');
        break;
      default:
        bytes.replace(at, count, bytes.substr(place(), count));
    }
  }
  return bytes;
}

void broken(const std::string& law) {
  std::fprintf(stderr, "broken: %s\n", law.c_str());
  std::abort();
}

}  // namespace texbake::fuzz
