// A verb of texbake: how it is told on the command line and what it then does.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "formats/bundle.h"

namespace texbake {

/// What a verb has to say when it is done.
struct Outcome {
  ExitCode code = ExitCode::done;
  std::string text;              ///< to stdout, for people; may be empty
  Json result = Json::object();  ///< to stdout with --json, as the member "result"
};

/// Runs the verb with the options that were parsed. Throws Error.
using Action = std::function<Outcome(Console&)>;

struct Command {
  std::string verb;
  std::string summary;  ///< one line
  std::string example;  ///< complete command lines
  /// Adds the verb's arguments; the action it returns is called after the parse and owns what they fill.
  std::function<Action(Arguments& arguments)> declare;
  std::string combinations = {};  ///< lines on which options do not go together, where there is something to say
};

/// Adds the positional BUNDLE that most verbs read.
void add_bundle_path(Arguments& arguments, std::string& path);

Command bake_command();
Command convert_command();
Command decompose_command();
Command estimate_psd_command();
Command export_command();
Command fragment_command();
Command heightmap_command();
Command info_command();
Command patch_command();
Command render_command();
Command report_command();
Command select_contents_command();
Command stack_command();
Command verify_command();

/// All of them, in the order in which the help lists them.
std::vector<Command> all_commands();

}  // namespace texbake
