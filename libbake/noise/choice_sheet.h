// A picture to choose the size of local spectra by eye: what each size takes for structure and for noise, and what is
// made of them again. Based on: Guingo et al. 2017, Fig. 14.
#pragma once

#include <span>

#include "libbake/noise/decompose.h"

namespace texbake {

/// One row for each candidate, from the top: exemplar, structure, noise about middle gray, synthesis; a dark frame
/// between, a light one around the row of `chosen` (its T_loc). Tiles wider or higher than `side` texels are cut to
/// their upper left corner. Linear Rec.709.
Image<V3f> choice_sheet(ImageView<const V3f> exemplar, std::span<const LocalSizeCandidate> candidates, int chosen,
                        int side = 512);

}  // namespace texbake
