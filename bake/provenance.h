// Keeps a bundle's record of its stages true: a stage that runs again replaces its record and drops what was made from
// what it replaces. Which stages those are follows from formats/stage_table.h.
#pragma once

#include <string>
#include <vector>

#include "formats/bundle.h"

namespace texbake {

/// Takes the results and the records of `verb`, and of all stages derived from it, out of `bundle`. Returns the verbs
/// that were derived, in order.
std::vector<std::string> drop_stage(Bundle& bundle, const std::string& verb);

/// The record of `verb`, or nullptr when it has not run.
const Stage* find_stage(const Bundle& bundle, const std::string& verb);

}  // namespace texbake
