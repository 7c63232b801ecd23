// usage: write_golden_page NAME FOLDER: exports the golden tile NAME as `texbake export --web` exports a bundle.
#include <algorithm>
#include <cstdio>

#include "pages/web_export.h"
#include "tests/golden/golden_stack.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    const std::string name = argv[1];
    const auto& stacks = texbake::kGoldenStackNames;
    if (std::find(std::begin(stacks), std::end(stacks), name) != std::end(stacks)) {
      const texbake::GoldenStack golden = texbake::read_golden_stack(name);
      texbake::export_web(golden.planes, golden.relief ? &*golden.relief : nullptr, argv[2]);
    } else {
      texbake::export_web(texbake::read_golden(name).planes, argv[2]);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_golden_page: %s\n", error.what());
    return 1;
  }
  return 0;
}
