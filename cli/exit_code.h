// How a run of texbake ended, the same for every verb. A count is never an exit code.
#pragma once

#include "libbake/base/error.h"

namespace texbake {

enum class ExitCode {
  done = 0,
  no = 1,           ///< the question was answered no: verify found the bundle invalid or different
  usage = 2,        ///< an unknown verb, option or value
  bad_data = 3,     ///< an input was read but does not hold what it must
  io = 4,           ///< an input cannot be read, or an output cannot be written
  unsupported = 5,  ///< a version or a feature this program does not know
  infeasible = 6,   ///< the algorithm cannot satisfy the request
  limit = 7,        ///< a limit the user set was reached
  internal = 8,     ///< internal error (please report it)
  // 128 + the number of the signal that ended the program, temporary files removed:
  interrupted = 130,
  no_reader = 141,  ///< whoever reads the result on stdout has gone
  terminated = 143,
};

/// What people and programs are told of an exit code.
struct ExitCodeWords {
  ExitCode code;
  const char* name;     ///< in JSON output
  const char* meaning;  ///< in the manual page
};
inline constexpr ExitCodeWords kExitCodes[] = {
    {ExitCode::done, "done", "done"},
    {ExitCode::no, "no",
     "the question was answered no: verify found the bundle invalid or different, or report judged it as --fail-on "
     "says"},
    {ExitCode::usage, "usage", "an unknown verb, option or value"},
    {ExitCode::bad_data, "bad-data", "an input was read but does not hold what it must"},
    {ExitCode::io, "io", "an input cannot be read, or an output cannot be written"},
    {ExitCode::unsupported, "unsupported", "a version or a feature that this program does not know"},
    {ExitCode::infeasible, "infeasible", "the algorithm cannot satisfy the request"},
    {ExitCode::limit, "limit", "a limit that was set, such as --max-memory, was reached"},
    {ExitCode::internal, "internal",
     "an internal error, which please report with the command line and the input; or the system has no memory or "
     "thread "
     "left"},
    {ExitCode::interrupted, "interrupted", "interrupted (SIGINT); temporary files were removed"},
    {ExitCode::no_reader, "no-reader",
     "the reader of standard output has gone; what was to be written to files has been written"},
    {ExitCode::terminated, "terminated", "terminated (SIGTERM); temporary files were removed"},
};

inline ExitCode exit_code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return ExitCode::usage;
    case ErrorKind::bad_data:
      return ExitCode::bad_data;
    case ErrorKind::io:
      return ExitCode::io;
    case ErrorKind::unsupported:
      return ExitCode::unsupported;
    case ErrorKind::infeasible:
      return ExitCode::infeasible;
    case ErrorKind::limit:
      return ExitCode::limit;
  }
  return ExitCode::internal;
}

/// The name of an exit code in JSON output.
inline const char* exit_name(ExitCode code) {
  for (const ExitCodeWords& words : kExitCodes)
    if (words.code == code) return words.name;
  return "internal";
}

}  // namespace texbake
