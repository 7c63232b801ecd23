// The noise layer's planes, as shaders/noise.glsl reads them.
#pragma once

#include <optional>

#include "libbake/planes/evaluator_input.h"

namespace texbake {

/// Sets masks, noises and the kind of the base of `planes`, whose base and grain_apart are there. Throws
/// Error(bad_data) for noises that do not fit.
void add_noise(const std::optional<NoiseInput>& input, TilePlanes& planes);

}  // namespace texbake
