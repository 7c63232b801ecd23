// Reads the words of a command line.
#pragma once

#include <span>
#include <string>

#include "cli/command_line.h"

namespace texbake {

/// What the words ask for.
struct Asked {
  enum class For { run, help, version } what = For::run;
  const Verb* verb = nullptr;  ///< of the command line; nullptr for the help or the version of the program
};

/// Reads the words after the name of the program. What was given is assigned to the arguments of `line` in the order of
/// their declaration, but nothing where help or the version is asked for. Throws Error(usage), with a suggestion where
/// a word is near a known one, and whatever the arguments throw.
Asked parse(const CommandLine& line, std::span<const std::string> words);

/// The same for `arguments` alone.
void parse(const Arguments& arguments, std::span<const std::string> words);

}  // namespace texbake
