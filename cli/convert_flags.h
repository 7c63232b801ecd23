// The flags of convert, which bake takes too.
#pragma once

#include "bake/convert_stage.h"
#include "cli/arguments.h"

namespace texbake {

/// Adds --map and every option of the stage. `request` must outlive the parse.
void add_convert_flags(Arguments& arguments, ConvertRequest& request);

}  // namespace texbake
