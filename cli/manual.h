// The manual pages, as troff reads them.
#pragma once

#include <string>

#include "cli/command_line.h"

namespace texbake {

/// texbake(1), and that of a verb of `line`: texbake-bake(1).
std::string manual_page(const CommandLine& line);
std::string manual_page(const CommandLine& line, const Verb& verb);

}  // namespace texbake
