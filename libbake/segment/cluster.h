// Clusters of fragments that are connected and unwrap to under half the tile: patches while they are being made.
#pragma once

#include "libbake/segment/circle_packing.h"
#include "libbake/segment/fragment_graph.h"

namespace texbake {

class Clusters {
 public:
  static constexpr uint32_t kNone = 0xffffffffu;

  /// Begins without clusters.
  Clusters(const FragmentMap& map, const FragmentGraph& graph);

  size_t count() const { return anchors_.size(); }
  uint32_t of(uint32_t fragment) const { return cluster_of_[fragment]; }
  uint64_t area_px(uint32_t cluster) const { return areas_[cluster]; }
  /// Whether the fragment must not leave its cluster: its anchor, and what has been pinned.
  bool is_pinned(uint32_t fragment) const { return is_pinned_[fragment] != 0; }

  /// Whether the cluster would stay under half the tile with the fragment. For fragments that touch it.
  bool fits(uint32_t fragment, uint32_t cluster) const;
  /// A new cluster of one free fragment, its anchor.
  void add_cluster(uint32_t anchor);
  void join(uint32_t fragment, uint32_t cluster);
  void leave(uint32_t fragment);
  void pin(uint32_t fragment) { is_pinned_[fragment] = 1; }
  /// Whether the cluster would certainly stay connected without the fragment: what it touches there hangs together near
  /// by.
  bool stays_connected_without(uint32_t fragment) const;
  /// Shrinks the bounding boxes after fragments have left.
  void tighten();

 private:
  /// A bounding box in the plane, relative to the first texel of the anchor's box.
  struct Box {
    V2i low, high;
  };
  Box box_of(uint32_t fragment, uint32_t cluster) const;
  static Box joined(const Box& a, const Box& b);

  const FragmentMap& map_;
  const FragmentGraph& graph_;
  std::vector<uint32_t> anchors_;
  std::vector<uint32_t> cluster_of_;  // of each fragment
  std::vector<uint8_t> is_pinned_;    // of each fragment
  std::vector<uint64_t> areas_;       // of each cluster
  std::vector<Box> boxes_;
};

/// Grows clusters from the circles, one for each: always the free fragment of least squared distance minus power that
/// touches its cluster and fits. Cluster 0 begins with the fragments around the corner of the tile, pinned. Where
/// fragments remain that fit nowhere, further clusters grow from them.
Clusters cluster_fragments(const FragmentMap& map, const FragmentGraph& graph, const CirclePacking& packing);

/// Moves single fragments between touching clusters while that lowers
///   balance · Σ over clusters (area / mean area − 1)²
///   + Σ over their borders (length / sqrt(mean area)) / (1 + (ΔE / mean ΔE)³):
/// similar areas and short borders, which may be longer where the picture steps more. At most `passes` passes. Of the
/// powers tried on photographs, the third gave the most contrast along the borders for the same evenness; the sixth
/// hides seams as well, with longer borders.
void refine(Clusters& clusters, const FragmentMap& map, const FragmentGraph& graph, double balance = 4,
            int passes = 30);

}  // namespace texbake
