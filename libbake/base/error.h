// The one exception of texbake: what a user's input did wrong, in words the user can act on.
#pragma once

#include <stdexcept>
#include <string>

namespace texbake {

/// Why a request cannot be carried out. The command line maps each kind to one exit code.
enum class ErrorKind {
  usage,        ///< the request itself is malformed: an unknown option, a value out of range
  bad_data,     ///< an input was read but does not hold what it must
  io,           ///< an input cannot be read, or an output cannot be written
  unsupported,  ///< a version or a feature this build does not know
  infeasible,   ///< the algorithm cannot satisfy the request on this input
  limit,        ///< a limit set by the user would be exceeded
};

/// Thrown for wrong user data. The message says what was expected, what was found, where, and how to mend it.
/// Mistakes of our own are asserted, not thrown.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace texbake
