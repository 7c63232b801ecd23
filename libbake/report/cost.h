// What drawing a material costs on a GPU, by each method.
#pragma once

#include "libbake/planes/prepare.h"
#include "libbake/report/measures.h"

namespace texbake {

/// Texture fetches for each texel at the finest level, tables excluded, and bytes of textures and tables without mip
/// levels, of the color and all maps: the bundle's k + 1 fetches
/// (with K noises k + 2 + K), periodic k, Wang k + 1 and 16 tiles, hex 3k. Colors
/// and three-channel maps count as RGBA16F, maps of one channel as R16F.
void add_cost(const EvaluatorPlanes& planes, std::array<MeasureRow, kMethodCount>& methods);

}  // namespace texbake
