// Evens out the areas of clusters and draws their borders to where the contrast is high.
#include <algorithm>
#include <cmath>
#include <map>

#include "libbake/segment/cluster.h"

namespace texbake {
namespace {

/// Mean step across the borders of fragments.
double mean_delta_e(const FragmentGraph& graph) {
  double sum = 0, length = 0;
  for (const FragmentLink& link : graph.links) {
    sum += static_cast<double>(link.length_px) * static_cast<double>(link.delta_e);
    length += link.length_px;
  }
  return length > 0 ? sum / length : 0;
}

class Refiner {
 public:
  Refiner(Clusters& clusters, const FragmentMap& map, const FragmentGraph& graph, double balance)
      : clusters_(clusters),
        map_(map),
        graph_(graph),
        balance_(balance),
        fair_(static_cast<double>(map.partition.idx.size()) / static_cast<double>(clusters.count())),
        mean_delta_e_(mean_delta_e(graph)) {}

  /// Moves every fragment that gains by it, once; the number of moves.
  int pass() {
    int moves = 0;
    for (uint32_t f = 0; f < graph_.count(); ++f)
      if (!clusters_.is_pinned(f) && move(f)) ++moves;
    clusters_.tighten();
    return moves;
  }

 private:
  double cost_of(const FragmentLink& link) const {
    const double contrast = mean_delta_e_ > 0 ? static_cast<double>(link.delta_e) / mean_delta_e_ : 0;
    return link.length_px / std::sqrt(fair_) / (1 + contrast * contrast * contrast);
  }

  double imbalance(double area) const { return balance_ * (area / fair_ - 1) * (area / fair_ - 1); }

  bool move(uint32_t fragment) {
    // What the borders towards each touching cluster cost now, and would save.
    const uint32_t home = clusters_.of(fragment);
    std::map<uint32_t, double> borders;
    for (const FragmentLink& link : graph_.links_of(fragment)) borders[clusters_.of(link.other)] += cost_of(link);
    if (borders.size() == 1 && borders.begin()->first == home) return false;

    const double area = map_.partition.areas_px[fragment];
    const auto home_area = static_cast<double>(clusters_.area_px(home));
    uint32_t best = home;
    double most = 1e-9;  // less is rounding
    for (const auto& [other, saved] : borders) {
      if (other == home) continue;
      const auto other_area = static_cast<double>(clusters_.area_px(other));
      const double gain = saved - borders[home] + imbalance(home_area) + imbalance(other_area) -
                          imbalance(home_area - area) - imbalance(other_area + area);
      if (gain <= most || !clusters_.fits(fragment, other)) continue;
      most = gain;
      best = other;
    }
    if (best == home || !clusters_.stays_connected_without(fragment)) return false;
    clusters_.leave(fragment);
    clusters_.join(fragment, best);
    return true;
  }

  Clusters& clusters_;
  const FragmentMap& map_;
  const FragmentGraph& graph_;
  const double balance_, fair_, mean_delta_e_;
};

}  // namespace

void refine(Clusters& clusters, const FragmentMap& map, const FragmentGraph& graph, double balance, int passes) {
  Refiner refiner(clusters, map, graph, balance);
  for (int i = 0; i < passes && refiner.pass() > 0; ++i) {
  }
}

}  // namespace texbake
