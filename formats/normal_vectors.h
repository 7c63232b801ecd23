// Makes vectors of what a normal map stores.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libbake/base/image.h"

namespace texbake {

/// How the numbers of a normal map were decoded so far.
enum class NormalNumbers {
  codes,    ///< integers, by their codes: −1 … 1
  floats,   ///< as they are stored: vectors, or 0 … 1 for −1 … 1
  vectors,  ///< floats that are vectors by the names of their channels
};

/// Turns `planes`, x, y and, where it is stored, z, into vectors of three planes. Floats are vectors where one is
/// negative, or where nearly all are of unit length; else 0 … 1 means −1 … 1. A z that is missing, or 0 everywhere as
/// stored, is √(1 − x² − y²). Returns what a person should know: one sentence each; among them how many vectors are not
/// of unit length.
std::vector<std::string> finish_normals(Image<float> (&planes)[3], size_t stored, NormalNumbers numbers);

}  // namespace texbake
