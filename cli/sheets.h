// The option --sheet: a picture of choices beside what a verb writes.
#pragma once

#include <string>

#include "cli/command.h"
#include "libbake/report/sheet.h"

namespace texbake {

/// `file` must outlive the parse.
void add_sheet_flag(Arguments& arguments, std::string& file);
/// Throws Error(usage) or Error(io) where no picture can be written to `file`; "" stands for no sheet.
void check_sheet(const std::string& file);
void write_sheet(const std::string& file, const Sheet& sheet);

}  // namespace texbake
