#include "libbake/segment/cluster.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace texbake {
namespace {

/// Fragments looked at to see that a cluster hangs together around one that leaves.
constexpr size_t kNearBy = 64;

V2d middle_of(const FragmentMap& map, uint32_t fragment) {
  const V2i c = map.partition.centers[fragment];
  return {c.x + 0.5, c.y + 0.5};
}

/// The fragments that hold the four texels around the corner, the one of texel (0, 0) first.
std::vector<uint32_t> corner_fragments(const FragmentMap& map) {
  const Image<uint32_t>& idx = map.partition.idx;
  const int right = idx.width() - 1, bottom = idx.height() - 1;
  std::vector<uint32_t> corner;
  for (const uint32_t f : {idx(0, 0), idx(right, 0), idx(0, bottom), idx(right, bottom)})
    if (std::find(corner.begin(), corner.end(), f) == corner.end()) corner.push_back(f);
  return corner;
}

/// One fragment for each circle, the nearest that is not taken; the first circle has that of texel (0, 0).
std::vector<uint32_t> anchors_of(const FragmentMap& map, const CirclePacking& packing,
                                 const std::vector<uint32_t>& corner) {
  std::vector<uint8_t> is_taken(map.fragments.size(), 0);
  // With few fragments the anchors need those around the corner, too.
  if (map.fragments.size() - corner.size() + 1 >= packing.centers.size())
    for (const uint32_t f : corner) is_taken[f] = 1;
  is_taken[corner[0]] = 1;
  std::vector<uint32_t> anchors{corner[0]};
  for (size_t i = 1; i < packing.centers.size(); ++i) {
    uint32_t nearest = Clusters::kNone;
    double least = std::numeric_limits<double>::infinity();
    for (uint32_t f = 0; f < is_taken.size(); ++f) {
      const double distance = packing.squared_distance(middle_of(map, f), i);
      if (is_taken[f] || distance >= least) continue;
      least = distance;
      nearest = f;
    }
    is_taken[nearest] = 1;
    anchors.push_back(nearest);
  }
  return anchors;
}

/// A free fragment and a cluster that it touches.
struct Offer {
  double key;
  uint32_t fragment, cluster;
  bool operator>(const Offer& b) const {
    if (key != b.key) return key > b.key;
    return fragment != b.fragment ? fragment > b.fragment : cluster > b.cluster;
  }
};

class Growing {
 public:
  Growing(const FragmentMap& map, const FragmentGraph& graph, const CirclePacking& packing)
      : map_(map), graph_(graph), packing_(packing), clusters_(map, graph) {}

  Clusters run() {
    const std::vector<uint32_t> corner = corner_fragments(map_);
    for (const uint32_t anchor : anchors_of(map_, packing_, corner)) clusters_.add_cluster(anchor);
    for (const uint32_t f : corner)
      if (clusters_.of(f) == Clusters::kNone && clusters_.fits(f, 0)) {
        clusters_.join(f, 0);
        clusters_.pin(f);
      }
    for (uint32_t f = 0; f < graph_.count(); ++f)
      if (clusters_.of(f) != Clusters::kNone) offer_neighbors(f);
    take_offers();

    for (uint32_t f = 0; f < graph_.count(); ++f) {
      if (clusters_.of(f) != Clusters::kNone) continue;
      clusters_.add_cluster(f);
      packing_.centers.push_back(middle_of(map_, f));
      packing_.power.push_back(0);
      offer_neighbors(f);
      take_offers();
    }
    return std::move(clusters_);
  }

 private:
  void offer_neighbors(uint32_t fragment) {
    const uint32_t cluster = clusters_.of(fragment);
    for (const FragmentLink& link : graph_.links_of(fragment))
      if (clusters_.of(link.other) == Clusters::kNone)
        offers_.push({packing_.squared_distance(middle_of(map_, link.other), cluster) - packing_.power[cluster],
                      link.other, cluster});
  }

  void take_offers() {
    while (!offers_.empty()) {
      const Offer offer = offers_.top();
      offers_.pop();
      if (clusters_.of(offer.fragment) != Clusters::kNone || !clusters_.fits(offer.fragment, offer.cluster)) continue;
      clusters_.join(offer.fragment, offer.cluster);
      offer_neighbors(offer.fragment);
    }
  }

  const FragmentMap& map_;
  const FragmentGraph& graph_;
  CirclePacking packing_;
  Clusters clusters_;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers_;
};

}  // namespace

Clusters::Clusters(const FragmentMap& map, const FragmentGraph& graph)
    : map_(map), graph_(graph), cluster_of_(graph.count(), kNone), is_pinned_(graph.count(), 0) {}

void Clusters::add_cluster(uint32_t anchor) {
  const auto cluster = static_cast<uint32_t>(anchors_.size());
  anchors_.push_back(anchor);
  areas_.push_back(0);
  boxes_.push_back(box_of(anchor, cluster));
  join(anchor, cluster);
  pin(anchor);
}

Clusters::Box Clusters::box_of(uint32_t fragment, uint32_t cluster) const {
  const TorusBox &box = graph_.boxes[fragment], &anchor = graph_.boxes[anchors_[cluster]];
  const V2i low = shortest(V2i(box.low.x - anchor.low.x, box.low.y - anchor.low.y), map_.partition.size());
  return {low, V2i(low.x + box.extent.x - 1, low.y + box.extent.y - 1)};
}

Clusters::Box Clusters::joined(const Box& a, const Box& b) {
  return {V2i(std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)),
          V2i(std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y))};
}

bool Clusters::fits(uint32_t fragment, uint32_t cluster) const {
  const Box box = joined(boxes_[cluster], box_of(fragment, cluster));
  return box.high.x - box.low.x < max_extent(map_.partition.size().x) &&
         box.high.y - box.low.y < max_extent(map_.partition.size().y);
}

void Clusters::join(uint32_t fragment, uint32_t cluster) {
  cluster_of_[fragment] = cluster;
  areas_[cluster] += map_.partition.areas_px[fragment];
  boxes_[cluster] = joined(boxes_[cluster], box_of(fragment, cluster));
}

void Clusters::leave(uint32_t fragment) {
  areas_[cluster_of_[fragment]] -= map_.partition.areas_px[fragment];
  cluster_of_[fragment] = kNone;
}

bool Clusters::stays_connected_without(uint32_t fragment) const {
  const uint32_t cluster = cluster_of_[fragment];
  std::vector<uint32_t> missing;
  for (const FragmentLink& link : graph_.links_of(fragment))
    if (cluster_of_[link.other] == cluster) missing.push_back(link.other);
  if (missing.empty()) return false;
  std::vector<uint32_t> reached{missing.back()};
  missing.pop_back();
  for (size_t head = 0; head < reached.size() && !missing.empty() && reached.size() < kNearBy; ++head)
    for (const FragmentLink& link : graph_.links_of(reached[head])) {
      if (link.other == fragment || cluster_of_[link.other] != cluster) continue;
      if (std::find(reached.begin(), reached.end(), link.other) != reached.end()) continue;
      reached.push_back(link.other);
      std::erase(missing, link.other);
    }
  return missing.empty();
}

void Clusters::tighten() {
  for (uint32_t cluster = 0; cluster < anchors_.size(); ++cluster) boxes_[cluster] = box_of(anchors_[cluster], cluster);
  for (uint32_t f = 0; f < cluster_of_.size(); ++f)
    boxes_[cluster_of_[f]] = joined(boxes_[cluster_of_[f]], box_of(f, cluster_of_[f]));
}

Clusters cluster_fragments(const FragmentMap& map, const FragmentGraph& graph, const CirclePacking& packing) {
  return Growing(map, graph, packing).run();
}

}  // namespace texbake
