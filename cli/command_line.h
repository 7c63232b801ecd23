// The whole command line, declared: every verb with its arguments, and what all verbs take.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/global_options.h"

namespace texbake {

/// "0.2.0"
const char* program_version();

inline constexpr const char* kProgramBrief = "bakes a photograph into an endless, non-repeating texture";
inline constexpr const char* kProgramSummary = "texbake bakes a photograph into an endless, non-repeating texture.";
inline constexpr const char* kHelpSummary =
    "show the help of a verb: texbake help VERB, the same as texbake VERB --help";
inline constexpr const char* kProgramExample =
    "  texbake bake leaves.jpg -o leaves.texbundle\n"
    "  texbake render leaves.texbundle -o leaves_large.png --size 4096x4096";

/// A verb whose arguments are declared. `action` runs it with what a parse has assigned to them.
struct Verb {
  Command command;
  Arguments arguments;
  Action action;

  const std::string& name() const { return command.verb; }
};

class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  const std::vector<Verb>& verbs() const { return verbs_; }
  /// nullptr for a word that is no verb.
  const Verb* find(const std::string& name) const;
  std::vector<std::string> verb_names() const;

  /// What stands in the place of a verb: --version.
  const Arguments& program() const { return program_; }
  /// What every verb takes, after the verb or before it: --help and the global options.
  const Arguments& common() const { return common_; }
  /// What a parse has assigned to `common`.
  const GlobalOptions& global() const { return global_; }

 private:
  GlobalOptions global_;
  Arguments program_;
  Arguments common_;
  std::vector<Verb> verbs_;
};

}  // namespace texbake
