// The program texbake: finds the verb, reads its options, runs it and tells how it ended.
#pragma once

namespace texbake {

/// Returns the exit code of the process. Nothing is thrown.
int run_program(int argc, const char* const* argv);

}  // namespace texbake
