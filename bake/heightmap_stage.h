// The stage heightmap on a bundle: places the clicks on the tile, runs, records.
#pragma once

#include "bake/listener.h"
#include "formats/bundle.h"
#include "formats/click_file.h"
#include "libbake/height/heightmap.h"

namespace texbake {

/// Where the coordinates of clicks count from.
enum class ClickSpace {
  tile,    ///< texels of the tile
  source,  ///< texels of the photograph that the tile was cut from
};

/// The clicks in texels of the tile. A click outside it is left to heightmap's check. Throws Error(bad_data) for a
/// sparse picture of another size than the tile or, in source coordinates, than the source.
std::vector<HeightClick> clicks_on_tile(const ClickFile& file, const Bundle& bundle, ClickSpace space);

/// Gives the only scale of `bundle` a height map. Nothing is dropped: no other stage reads it.
void run_heightmap(Bundle& bundle, const ClickFile& file, ClickSpace space, const HeightmapOptions& options,
                   Listener& listener);

}  // namespace texbake
