// Breaks text into lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace texbake {

/// How many columns UTF-8 text of letters and signs takes: its code points.
int columns_of(std::string_view text);

/// `text` in lines of at most `width` columns, broken at spaces; a longer word is broken after a '|', a ',' or, where
/// it has none, nowhere.
std::vector<std::string> wrapped(std::string_view text, int width);

/// A command line in lines of at most `width` columns that a shell reads as one: " \" ends each but the last. A word is
/// never broken, and an option stays with its value.
std::vector<std::string> wrapped_command(std::string_view command, int width);

}  // namespace texbake
