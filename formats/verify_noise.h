// Checks of the noises that need their pixels: masks, spectra, axes, tiles, and whether they fit the exemplar.
#pragma once

#include "formats/bundle_io.h"
#include "formats/verify_scale.h"

namespace texbake {

/// Are the masks multiples of 1/2048 that sum to 1?
void check_mask_sums(const ScaleUnderTest& test, IssueLog& log);

/// Spectra, axes and tiles by themselves, and against exemplar − structure of the finest scale.
void check_noise(const LoadedBundle& loaded, IssueLog& log);

}  // namespace texbake
