#include "libbake/segment/patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "libbake/base/error.h"
#include "libbake/color/luv.h"
#include "libbake/segment/cluster.h"

namespace texbake {
namespace {

constexpr int kTypicalCount = 16;  // the paper: 10 to 20
constexpr int kFragmentsPerPatch = 4;
constexpr int kSafeCount = 9;   // thirds of the tile: well under half of it
constexpr int kLeastCount = 5;  // a patch under half the tile on each axis has less than a quarter of its area
constexpr uint32_t kAttempts = 8;

int automatic_count(int fragments) {
  const int enough = std::clamp(fragments / kFragmentsPerPatch, kSafeCount, kTypicalCount);
  return std::max(1, std::min(enough, fragments));
}

void check_count(int count, const FragmentMap& fragments) {
  const int available = fragments.partition.count();
  if (count > available)
    throw Error(ErrorKind::infeasible, fmt::format("expected at least {} fragments, one for each patch, found {}; ask "
                                                   "for --count {} or fewer, or run fragment with a smaller --max-area",
                                                   count, available, available));
  if (count < kLeastCount)
    throw Error(ErrorKind::infeasible,
                fmt::format("expected at least {} patches, found --count {}: a patch must be smaller than half the "
                            "tile on each axis, and therefore smaller than a quarter of its area",
                            kLeastCount, count));
}

/// Of several packings, the first that needs no cluster beyond `count`, else the one that needs the fewest.
Clusters clusters_of(const FragmentMap& fragments, const FragmentGraph& graph, int count, uint32_t seed) {
  std::vector<V2d> middles;
  for (const V2i& c : fragments.partition.centers) middles.emplace_back(c.x + 0.5, c.y + 0.5);
  std::optional<Clusters> best;
  for (uint32_t attempt = 0; attempt < kAttempts; ++attempt) {
    const CirclePacking packing =
        balance(pack_circles(fragments.partition.size(), count, seed, attempt), middles, fragments.partition.areas_px);
    Clusters clusters = cluster_fragments(fragments, graph, packing);
    if (!best || clusters.count() < best->count()) best.emplace(std::move(clusters));
    if (best->count() == static_cast<size_t>(count)) break;
  }
  return *std::move(best);
}

/// The patch of each texel, numbered by their first texel in row order.
Image<uint32_t> idx_of(const Clusters& clusters, const Image<uint32_t>& fragment_idx) {
  Image<uint32_t> idx(fragment_idx.width(), fragment_idx.height());
  std::vector<uint32_t> number(clusters.count(), Clusters::kNone);
  uint32_t next = 0;
  for (size_t at = 0; at < idx.size(); ++at) {
    uint32_t& patch = number[clusters.of(fragment_idx.data()[at])];
    if (patch == Clusters::kNone) patch = next++;
    idx.data()[at] = patch;
  }
  return idx;
}

}  // namespace

PatchOptions resolve(const PatchOptions& options, const FragmentMap& fragments) {
  check_options(options);
  PatchOptions resolved = options;
  if (!resolved.count) resolved.count = automatic_count(fragments.partition.count());
  return resolved;
}

PatchMap patch(const FragmentMap& fragments, ImageView<const V3f> base, const PatchOptions& options,
               const Progress& progress) {
  const PatchOptions resolved = resolve(options, fragments);
  check_count(*resolved.count, fragments);
  const FragmentGraph graph = fragment_graph(fragments, luv_from_linear(base));
  report_progress(progress, 0.3);
  Clusters clusters = clusters_of(fragments, graph, *resolved.count, resolved.seed);
  report_progress(progress, 0.6);
  refine(clusters, fragments, graph);
  report_progress(progress, 0.8);
  PatchMap map{unwrap(idx_of(clusters, fragments.partition.idx))};
  report_progress(progress, 1.0);
  return map;
}

}  // namespace texbake
