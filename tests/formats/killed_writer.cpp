// Writes a bundle and kills itself before a given step: killed_writer BUNDLE MARK STEP. Without STEP it writes the
// marks 0.25 and 0.75 in turn until somebody else kills it.
#include <csignal>
#include <cstdlib>

#include "tests/formats/bundle_fixtures.h"

int main(int argc, char** argv) {
  using namespace texbake;
  if (argc == 4) {
    int left = std::atoi(argv[3]);
    const auto kill_at_step = [&](std::string_view) {
      if (left-- == 0) std::raise(SIGKILL);
    };
    write_bundle(bundle_with_everything(static_cast<float>(std::atof(argv[2]))), argv[1], {.hook = kill_at_step});
    return 0;
  }
  const Bundle one = bundle_with_everything(0.25f), other = bundle_with_everything(0.75f);
  while (true) {
    write_bundle(one, argv[1]);
    write_bundle(other, argv[1]);
  }
}
