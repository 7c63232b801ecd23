// The program texbake: finds the verb, reads its options, runs it and tells how it ended.
#pragma once

namespace texbake {

/// To be called before anything else, even before the libraries are initialized, some of which start threads: an
/// exception that nothing catches then ends the process with a message, exit code 8 and no temporary files.
void expect_failures();

/// Returns the exit code of the process. Nothing is thrown.
int run_program(int argc, const char* const* argv);

}  // namespace texbake
