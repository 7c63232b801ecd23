// What is measured: renderings of whole tiles in CIELUV, of the bundle and of what a user would pick instead.
#pragma once

#include <cstdint>

#include "libbake/planes/prepare.h"
#include "libbake/quality/seams.h"

namespace texbake {

/// `tiles` whole repetitions of the bundle's tile from the origin, drawn by strips.
Image<V3f> bundle_luv(const EvaluatorPlanes& planes, V2i tiles, uint32_t seed);

/// The same of a baseline made from the tile.
Image<V3f> periodic_luv(ImageView<const V3f> tile_luv, V2i tiles);
Image<V3f> wang_luv(ImageView<const V3f> tile_luv, V2i tiles, uint32_t seed);
/// `tile_linear` in linear Rec.709: its colors are blended as light.
Image<V3f> hex_luv(ImageView<const V3f> tile_linear, V2i tiles, uint32_t seed);

/// Where a rendering takes its texels from: what seams are found by.
struct RenderingSources {
  Image<V2i> source;
  Image<uint32_t> shape;  ///< see SeamOptions
  Image<V3f> shown;       ///< with soft borders or noise: the rendering in CIELUV; else empty
};
RenderingSources bundle_sources(const EvaluatorPlanes& planes, V2i tiles, uint32_t seed);
RenderingSources periodic_sources(V2i tile, V2i tiles);
RenderingSources wang_sources(ImageView<const V3f> tile_luv, V2i tiles, uint32_t seed);

}  // namespace texbake
