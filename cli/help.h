// The text of --help.
#pragma once

#include <string>

#include "cli/command_line.h"

namespace texbake {

/// In how many columns help is written: what COLUMNS says, else the width of the terminal, but at least 60; 100 where
/// stdout is no terminal.
int help_width();

/// The help of the program, or of a verb of `line`, in lines of at most `width` characters.
std::string help_text(const CommandLine& line, int width);
std::string help_text(const CommandLine& line, const Verb& verb, int width);

/// "the help; may be repeated; default: 1": all that is said of an argument, in one sentence.
std::string description_of(const Argument& argument);
/// "-j, --threads 0 to 1024 threads", or the name of a positional.
std::string heading_of(const Argument& argument);
/// "texbake stack [OPTIONS] BUNDLES... -o BUNDLE"
std::string usage_of(const Verb& verb);

}  // namespace texbake
