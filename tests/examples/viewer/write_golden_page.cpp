// usage: write_golden_page NAME FOLDER: exports the golden tile NAME as `texbake export --web` exports a bundle.
#include <cstdio>

#include "formats/web_export.h"
#include "tests/golden/golden_stack.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    if (argv[1] == std::string(texbake::kGoldenStackName))
      texbake::export_web(texbake::read_golden_stack().planes, argv[2]);
    else
      texbake::export_web(texbake::read_golden(argv[1]).planes, argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_golden_page: %s\n", error.what());
    return 1;
  }
  return 0;
}
