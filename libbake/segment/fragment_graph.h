// Which fragments touch, along how many texel edges, and how much the picture steps there.
#pragma once

#include <span>

#include "libbake/segment/fragment.h"
#include "libbake/segment/torus_box.h"

namespace texbake {

/// One side of a border between two fragments.
struct FragmentLink {
  uint32_t other = 0;      ///< the fragment beyond the border
  uint32_t length_px = 0;  ///< edges between texels that the two share
  float delta_e = 0;       ///< mean step of the picture across these edges, in CIELUV
};

struct FragmentGraph {
  std::vector<size_t> first;        ///< of each fragment's links, and the end: count + 1
  std::vector<FragmentLink> links;  ///< by fragment, then by `other`
  std::vector<TorusBox> boxes;      ///< bounding box of each fragment

  uint32_t count() const { return static_cast<uint32_t>(boxes.size()); }
  std::span<const FragmentLink> links_of(uint32_t fragment) const {
    return std::span(links).subspan(first[fragment], first[fragment + 1] - first[fragment]);
  }
};

/// `luv` is the picture that was fragmented, in CIELUV. Its steps are what hides a seam; mean colors of fragments may
/// differ where the picture does not step.
FragmentGraph fragment_graph(const FragmentMap& map, ImageView<const V3f> luv);

}  // namespace texbake
