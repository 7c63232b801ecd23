// The options that every verb takes.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

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

/// `options` must outlive the parse.
void add_global_flags(CLI::App& app, GlobalOptions& options);

}  // namespace texbake
