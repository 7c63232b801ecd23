#include "cli/command_line.h"

#include <algorithm>

namespace texbake {

const char* program_version() { return TEXBAKE_VERSION; }

CommandLine::CommandLine() {
  program_.flag({.name = "version", .help = "print the version and exit", .assign = {}});
  common_.flag(
      {.name = "help", .letter = 'h', .help = "print this help and exit", .group = kForEveryVerb, .assign = {}});
  add_global_flags(common_, global_);
  for (Command& command : all_commands()) {
    Verb verb{.command = std::move(command), .arguments = {}, .action = {}};
    verb.action = verb.command.declare(verb.arguments);
    verbs_.push_back(std::move(verb));
  }
}

const Verb* CommandLine::find(const std::string& name) const {
  const auto found = std::ranges::find(verbs_, name, &Verb::name);
  return found == verbs_.end() ? nullptr : &*found;
}

std::vector<std::string> CommandLine::verb_names() const {
  std::vector<std::string> names;
  for (const Verb& verb : verbs_) names.push_back(verb.name());
  return names;
}

}  // namespace texbake
