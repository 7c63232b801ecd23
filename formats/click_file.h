// Reads the heights that a person gave at some texels: as JSON, as CSV or as a sparse picture.
#pragma once

#include "formats/clicks.h"

namespace texbake {

/// The kind follows from the extension.
/// .json: a list, or an object whose member "clicks" is one, of {"x": 12, "y": 34, "height": 0.5} or [12, 34, 0.5];
/// .csv or .txt: x, y, height in a line, parted by commas, semicolons, tabs or spaces; lines that are empty or begin
/// with '#', and a first line of words, are left out;
/// any other: a picture, gray or with equal channels, integers as 0 … 1. Where it has alpha, texels of alpha 0 are no
/// clicks; without alpha, black texels are none.
/// Texel (x, y) has its upper left corner at (x, y): fractions are dropped. Heights are read as they stand.
/// Throws Error(io) when the file cannot be read, Error(bad_data), with the place, when it is none of these.
ClickFile read_clicks(const std::string& path);

}  // namespace texbake
