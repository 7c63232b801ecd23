// Where the texels that a content shows are taken from.
#pragma once

#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

/// The texel of the tile that shows at texel `p` of patch `patch`, or near its border, with `content`. A patch is under
/// half a tile wide, so the shortest offset from its center on the torus is the one in the plane.
inline V2i shown_source(const Partition& patches, uint32_t patch, V2i p, const Content& content) {
  const V2i center = patches.centers[patch];
  return wrap(center + source_offset(content, shortest(p - center, patches.size())), patches.size());
}

}  // namespace texbake
