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

inline constexpr ExitCode kExitCodes[] = {ExitCode::done,        ExitCode::no,        ExitCode::usage,
                                          ExitCode::bad_data,    ExitCode::io,        ExitCode::unsupported,
                                          ExitCode::infeasible,  ExitCode::limit,     ExitCode::internal,
                                          ExitCode::interrupted, ExitCode::no_reader, ExitCode::terminated};

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
  switch (code) {
    case ExitCode::done:
      return "done";
    case ExitCode::no:
      return "no";
    case ExitCode::usage:
      return "usage";
    case ExitCode::bad_data:
      return "bad-data";
    case ExitCode::io:
      return "io";
    case ExitCode::unsupported:
      return "unsupported";
    case ExitCode::infeasible:
      return "infeasible";
    case ExitCode::limit:
      return "limit";
    case ExitCode::internal:
      return "internal";
    case ExitCode::interrupted:
      return "interrupted";
    case ExitCode::no_reader:
      return "no-reader";
    case ExitCode::terminated:
      return "terminated";
  }
  return "internal";
}

/// What an exit code means, for the manual page.
inline const char* exit_meaning(ExitCode code) {
  switch (code) {
    case ExitCode::done:
      return "done";
    case ExitCode::no:
      return "the question was answered no: verify found the bundle invalid or different, or report judged it as "
             "--fail-on "
             "says";
    case ExitCode::usage:
      return "an unknown verb, option or value";
    case ExitCode::bad_data:
      return "an input was read but does not hold what it must";
    case ExitCode::io:
      return "an input cannot be read, or an output cannot be written";
    case ExitCode::unsupported:
      return "a version or a feature that this program does not know";
    case ExitCode::infeasible:
      return "the algorithm cannot satisfy the request";
    case ExitCode::limit:
      return "a limit that was set, such as --max-memory, was reached";
    case ExitCode::internal:
      return "an internal error, which please report with the command line and the input; or the system has no memory "
             "or "
             "thread left";
    case ExitCode::interrupted:
      return "interrupted (SIGINT); temporary files were removed";
    case ExitCode::no_reader:
      return "the reader of standard output has gone; what was to be written to files has been written";
    case ExitCode::terminated:
      return "terminated (SIGTERM); temporary files were removed";
  }
  return "";
}

}  // namespace texbake
