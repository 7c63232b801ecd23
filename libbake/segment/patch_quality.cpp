// How even the patches are, and how well their borders are hidden.
#include <algorithm>
#include <cmath>

#include "libbake/color/luv.h"
#include "libbake/segment/fragment_graph.h"
#include "libbake/segment/patch.h"

namespace texbake {
namespace {

/// The patch that each fragment lies in.
std::vector<uint32_t> patch_of_fragments(const PatchMap& patches, const FragmentMap& fragments) {
  std::vector<uint32_t> patch_of(fragments.fragments.size(), 0);
  for (size_t at = 0; at < patches.partition.idx.size(); ++at)
    patch_of[fragments.partition.idx.data()[at]] = patches.partition.idx.data()[at];
  return patch_of;
}

void measure_borders(const PatchMap& patches, const FragmentMap& fragments, ImageView<const V3f> base,
                     PatchQuality& quality) {
  const FragmentGraph graph = fragment_graph(fragments, luv_from_linear(base));
  const std::vector<uint32_t> patch_of = patch_of_fragments(patches, fragments);
  double patch_sum = 0, patch_length = 0, sum = 0, length = 0;
  for (uint32_t f = 0; f < graph.count(); ++f)
    for (const FragmentLink& link : graph.links_of(f)) {
      const double weighted = static_cast<double>(link.delta_e) * link.length_px;
      sum += weighted;
      length += link.length_px;
      if (patch_of[f] == patch_of[link.other]) continue;
      patch_sum += weighted;
      patch_length += link.length_px;
    }
  if (length > 0) quality.fragment_delta_e = sum / length;
  if (patch_length > 0) quality.border_delta_e = patch_sum / patch_length;
}

}  // namespace

PatchQuality patch_quality(const PatchMap& patches, const FragmentMap& fragments, ImageView<const V3f> base) {
  const Partition& partition = patches.partition;
  PatchQuality quality;
  const auto [least, most] = std::minmax_element(partition.areas_px.begin(), partition.areas_px.end());
  quality.min_area_px = *least;
  quality.max_area_px = *most;
  const double mean = static_cast<double>(partition.idx.size()) / partition.count();
  double squares = 0;
  for (const uint32_t area : partition.areas_px) squares += (area - mean) * (area - mean);
  quality.area_variation = std::sqrt(squares / partition.count()) / mean;

  std::vector<uint8_t> is_across(partition.areas_px.size(), 0);
  for (size_t at = 0; at < partition.idx.size(); ++at)
    if (partition.owner.data()[at] != OwnerOffset{}) is_across[partition.idx.data()[at]] = 1;
  quality.across_border = static_cast<int>(std::count(is_across.begin(), is_across.end(), 1));
  const int right = partition.size().x - 1, bottom = partition.size().y - 1;
  const Image<uint32_t>& idx = partition.idx;
  quality.is_across_corner =
      idx(0, 0) == idx(right, 0) && idx(0, 0) == idx(0, bottom) && idx(0, 0) == idx(right, bottom);
  measure_borders(patches, fragments, base, quality);
  return quality;
}

}  // namespace texbake
