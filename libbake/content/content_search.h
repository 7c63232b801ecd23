// Finds the translations of least impact for every patch, among all of them, exactly.
// Based on: Vanhoey et al. 2013, §5.2, eq. 2 and 3.
#pragma once

#include "libbake/base/progress.h"
#include "libbake/content/candidates.h"
#include "libbake/content/class_distances.h"
#include "libbake/content/patch_border.h"

namespace texbake {

/// take_separated of all width × height translations that are allowed, without computing all of their errors: a sum of
/// E never falls, so a translation is given up once its sum passes that of the last candidate.
SearchResult search_contents(ImageView<const uint8_t> classes, const ClassDistances& distances,
                             const PatchBorders& borders, const SearchRequest& request, const Progress& progress = {});

}  // namespace texbake
