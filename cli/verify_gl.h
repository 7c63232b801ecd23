// texbake verify --backend gl: the reference shader on OpenGL against the evaluator.
#pragma once

#include "cli/command.h"
#include "cli/gl_backend.h"

namespace texbake {

/// What was found, for people and for JSON; ExitCode::no where anything differs.
Outcome parity_outcome(const std::vector<LanguageParity>& languages, V2i tile_size);

}  // namespace texbake
