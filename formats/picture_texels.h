// Reads the texels of an opened file, band after band, into planes.
#pragma once

#include <cstddef>

#include "formats/picture.h"
#include "formats/picture_input.h"
#include "formats/picture_plan.h"

namespace texbake {

/// Are the integers of the file decoded by a table of their codes? Else its numbers are read as floats.
bool reads_codes(const PictureInput& open, const PicturePlan& plan);

/// Decodes every texel into `picture.channels` upright planes; returns how many texels are not opaque. Memory for the
/// planes is taken after the first rows were read well. Throws Error(bad_data) for a damaged file.
size_t read_texels(PictureInput& open, const PicturePlan& plan, PictureRole role, Picture& picture);

}  // namespace texbake
