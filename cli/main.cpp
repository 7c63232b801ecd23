#include "cli/program.h"

namespace {

// What the loader calls first of all.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kFirstOfAll)() = texbake::expect_failures;

}  // namespace

int main(int argc, char** argv) { return texbake::run_program(argc, argv); }
