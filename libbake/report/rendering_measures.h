// All numbers that are measured on one rendering against its exemplar.
#pragma once

#include <vector>

#include "libbake/report/measures.h"
#include "libbake/report/rendering.h"

namespace texbake {

/// Measures repetition, octave bands and fidelity of `rendering_luv` (whole tiles, CIELUV) against `exemplar_luv`, the
/// tile. What is not defined says why. `seed` picks the windows of the structure distance.
void measure_rendering(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv, uint32_t seed,
                       MeasureRow& row);

/// Measures the seams of a rendering that takes its texels from `sources`.
void measure_seams(ImageView<const V3f> exemplar_luv, const RenderingSources& sources, Adjacency adjacency,
                   MeasureRow& row);

/// The same measures of fidelity between the left and the right half of the exemplar: how much chance alone gives.
MeasureRow fidelity_floor(ImageView<const V3f> exemplar_luv);

/// Mean and standard deviation of every measure over the seeds. A measure that one seed does not define is not defined.
MeasureRow over_seeds(const std::vector<MeasureRow>& rows);

}  // namespace texbake
