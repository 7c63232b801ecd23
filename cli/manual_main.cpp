// Writes the manual pages and the completions below a folder, laid out as below /usr/share: texbake_manual FOLDER
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "cli/completions.h"
#include "cli/manual.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.exceptions(std::ios::badbit | std::ios::failbit);
  file << text << std::flush;
}

void write_all(const fs::path& folder) {
  const CommandLine line;
  write(folder / "man/man1/texbake.1", manual_page(line));
  for (const Verb& verb : line.verbs())
    write(folder / fmt::format("man/man1/texbake-{}.1", verb.name()), manual_page(line, verb));
  write(folder / "bash-completion/completions/texbake", bash_completion(line));
  write(folder / "zsh/site-functions/_texbake", zsh_completion(line));
  write(folder / "fish/vendor_completions.d/texbake.fish", fish_completion(line));
}

}  // namespace
}  // namespace texbake

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::invalid_argument("expected a folder");
    texbake::write_all(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "texbake_manual: {}\n", error.what());
    return 1;
  }
}
