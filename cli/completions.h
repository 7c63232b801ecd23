// What shells need to complete the command line: verbs, options, and the words, files and folders that they take.
#pragma once

#include <string>

#include "cli/command_line.h"

namespace texbake {

/// A script for bash, without the package bash-completion; a function for zsh; a script for fish.
std::string bash_completion(const CommandLine& line);
std::string zsh_completion(const CommandLine& line);
std::string fish_completion(const CommandLine& line);

}  // namespace texbake
