// Reads a picture of any format into planes of linear light, data, or normal vectors.
#pragma once

#include "formats/picture.h"
#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// Reads the first picture of the file at `request.path`, upright: the EXIF orientation is applied.
///
/// The format is that of its first bytes (formats/picture_format.h). Integers of b bits are divided by 2^b − 1; integer
/// normal maps follow formats/srgb_codes.h, and all of them formats/normal_vectors.h. Colors become linear Rec.709 as
/// formats/picture_color.h says. Palettes and 1, 2, 4 bits are expanded. The channels are those that
/// formats/picture_channels.h chooses. Alpha is dropped, and color divided by it where the format is premultiplied.
/// Data whose three channels are equal everywhere has one channel. Colors are ≥ 0 and ≤ 65504, the largest half float:
/// negative ones become 0. A missing end marker and a damaged chunk without texels are warnings, among the notes.
///
/// Throws Error(io) when the file cannot be opened; Error(usage) when it has no layer of the name that is asked for;
/// Error(unsupported) for other formats, deep or volume pictures, turned normal maps, and kinds of color that are not
/// supported; Error(bad_data) for what is cut off or damaged, is larger than kMaxPictureSide, has a number
/// of channels that does not suit `role`, or holds NaN, infinity or colors above 65504 (their count and first texel).
Picture read_picture(const PictureRequest& request);

/// Three planes as one image. All have the same size.
Image<V3f> interleave(const Image<float> (&planes)[3]);

}  // namespace texbake
