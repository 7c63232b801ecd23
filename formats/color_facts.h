// Collects what a file says of its colors, each format in its own way.
#pragma once

#include "formats/picture_color.h"
#include "formats/picture_input.h"
#include "formats/png_check.h"

namespace texbake {

/// Of the picture that `open` is at; `png` counts for PNG alone. Throws Error(unsupported) for the curves PQ and HLG.
ColorFacts color_facts(const PictureInput& open, const PngCheck& png);

}  // namespace texbake
