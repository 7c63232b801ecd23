// The search among contents that are also turned and scaled: a bound for all of them, the exact impact of the best.
// Based on: Vanhoey et al. 2013, §5.2, eq. 2 and 3; Guingo et al. 2017, §4.
#pragma once

#include <span>
#include <vector>

#include "libbake/content/content.h"
#include "libbake/content/content_search.h"
#include "libbake/segment/partition.h"

namespace texbake {

/// How a content may lie: a matrix as in Content, without translation.
using Turns = std::vector<Content>;

/// `rotations` multiples of a whole turn / rotations (1, 2, 4 or 8), each at `scales` sizes evenly spaced from 1 down
/// to `min_scale`, rounded to 1/64, equal ones once. Turn 0 is the identity; rotations of one size follow each other.
Turns make_turns(int rotations, int scales, float min_scale);

/// take_separated of the best translations with any of the turns (at one distance whatever the turn), with exact
/// errors. Not all of them are computed: for each patch those of the least bounds (turned_bound.h) over all turns,
/// enough of them far apart, and what lies around the best of these. `turns` is of make_turns.
SearchResult search_contents_turned(ImageView<const uint8_t> classes, const ClassDistances& distances,
                                    const Partition& patches, const Turns& turns, const SearchRequest& request,
                                    const Progress& progress = {});

}  // namespace texbake
