// The options that every verb takes, and that may also stand before the verb.
#pragma once

#include <cstdint>
#include <optional>

#include "cli/arguments.h"
#include "cli/console.h"

namespace texbake {

struct GlobalOptions {
  bool quiet = false;
  bool verbose = false;
  bool json = false;
  ProgressMode progress = ProgressMode::automatic;
  int threads = 0;  ///< 0: all
  std::optional<uint64_t> max_memory_bytes;

  Verbosity verbosity() const { return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal; }
};

/// The heading that they stand under.
inline constexpr const char* kForEveryVerb = "For every verb";

/// `options` must outlive the parse.
void add_global_flags(Arguments& arguments, GlobalOptions& options);

}  // namespace texbake
