// The flags of convert, which bake takes too.
#pragma once

#include <CLI/CLI.hpp>

#include "bake/convert_stage.h"

namespace texbake {

/// Adds --map and every option of the stage. `request` must outlive the parse.
void add_convert_flags(CLI::App& app, ConvertRequest& request);

}  // namespace texbake
