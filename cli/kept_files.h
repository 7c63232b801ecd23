// The files that a command leaves as they are, whatever it is told to write: what it reads, and what its bundle was
// made from.
#pragma once

#include <span>
#include <string>

#include "formats/bundle.h"

namespace texbake {

/// Throws Error(usage) where `output` is one of `inputs`, files or folders. "" is no output.
void check_keeps_inputs(const std::string& output, std::span<const std::string> inputs);

/// Throws Error(usage) where the file `output` has the contents of a source of `bundle`: it is that source, or a copy.
void check_keeps_sources(const std::string& output, const Bundle& bundle);

/// What the bundle at `path` has that `bundle`, about to take its place, will not have, in sentences for people.
/// Nothing where there is no bundle at `path`.
std::vector<std::string> losses(const std::string& path, const Bundle& bundle);

}  // namespace texbake
