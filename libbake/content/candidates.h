// What a search for contents asks for and finds.
// Based on: Vanhoey et al. 2013, §5.2, eq. 2 and 3.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// A translation that a patch may use.
struct Candidate {
  V2i translation{0, 0};   ///< 0 … size−1
  uint64_t error_sum = 0;  ///< Σ E over dil(∂P), in squared distance steps
  int turn = 0;            ///< with which of the turns of the search, see turned_search.h
  bool operator==(const Candidate&) const = default;
};

/// The candidates of one patch, least error first; among equals the least (y, x, turn) first.
using Candidates = std::vector<Candidate>;

struct SearchRequest {
  int count = 60;                         ///< candidates wanted for each patch
  int separation_px = 16;                 ///< least distance, see far_enough
  ImageView<const uint8_t> allowed = {};  ///< by translation, 0 … size−1: 0 for those to leave out; empty: none
};

struct SearchResult {
  std::vector<Candidates> candidates;  ///< for each patch; fewer than asked for only where no more are far enough apart
  uint64_t error_count = 0;            ///< of E computed
  uint64_t all_error_count = 0;        ///< of E that a search without bounds computes, each patch on its own
};

/// Takes from `found`, in order of (error, y, x, turn), what is far enough from the identity and from everything taken
/// before, up to `request.count`.
Candidates take_separated(const Candidates& found, V2i size, const SearchRequest& request);

}  // namespace texbake
