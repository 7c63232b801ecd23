// The search for large tiles: at reduced size first, then exactly around the best translations found there.
// Based on: Vanhoey et al. 2013, §5.2, eq. 2 and 3.
#pragma once

#include "libbake/content/content_search.h"

namespace texbake {

/// The best translations whose neighborhoods are ranked again at full size, for each patch.
inline constexpr int kRefinedNeighborhoods = 1000;
/// A tile is halved until its longer side is at most this many texels.
inline constexpr int kExactSide = 1024;

/// As search_contents, with errors that are exact but not of all translations: those around the best
/// kRefinedNeighborhoods translations of each patch on the reduced tile, and around those of its translations that are
/// as far apart as asked for. The reduced tile's texels take the most frequent class and patch of the block they stand
/// for (the least of equally frequent ones). Tiles of up to kExactSide are searched whole.
SearchResult search_contents_refined(ImageView<const uint8_t> classes, const ClassDistances& distances,
                                     ImageView<const uint32_t> patch_idx, int patch_count, const SearchRequest& request,
                                     const Progress& progress = {});

}  // namespace texbake
