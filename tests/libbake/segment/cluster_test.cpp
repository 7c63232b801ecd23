#include "libbake/segment/cluster.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libbake/segment/oracle.h"
#include "tests/libbake/segment/random_tile.h"

namespace texbake {
namespace {

struct Case {
  FragmentMap map;
  FragmentGraph graph;
  CirclePacking packing;
};

Case case_of(uint32_t seed, V2i size = V2i(128, 96), int count = 14) {
  Case given;
  const auto tile = random_tile(size.x, size.y, 3, seed);
  given.map = fragment(tile, decode(tile), {.seed = seed});
  given.graph = fragment_graph(given.map, luv_of(tile));
  given.packing = pack_circles(size, count, seed);
  return given;
}

Image<uint32_t> idx_of(const Case& given, const Clusters& clusters) {
  Image<uint32_t> idx(given.map.partition.idx.width(), given.map.partition.idx.height());
  for (size_t at = 0; at < idx.size(); ++at) idx.data()[at] = clusters.of(given.map.partition.idx.data()[at]);
  return idx;
}

/// What refine lowers, summed texel edge by texel edge.
double cost(const Case& given, const Clusters& clusters, double balance) {
  const auto delta_e = [&](uint32_t a, uint32_t b) {
    for (const auto& link : given.graph.links_of(a))
      if (link.other == b) return static_cast<double>(link.delta_e);
    return 0.0;
  };
  const Image<uint32_t>& fragment_idx = given.map.partition.idx;
  const Image<uint32_t> idx = idx_of(given, clusters);
  const double fair = static_cast<double>(idx.size()) / static_cast<double>(clusters.count());
  double contrast = 0, edges = 0, borders = 0;
  for (const bool is_mean_known : {false, true})
    for (int y = 0; y < idx.height(); ++y)
      for (int x = 0; x < idx.width(); ++x)
        for (int n = 0; n < 2; ++n) {
          const V2i q = wrap(V2i(x + kNeighborX[n], y + kNeighborY[n]), V2i(idx.width(), idx.height()));
          const uint32_t a = fragment_idx(x, y), b = fragment_idx(q.x, q.y);
          if (a == b) continue;
          if (!is_mean_known) {
            contrast += delta_e(a, b);
            ++edges;
          } else if (idx(x, y) != idx(q.x, q.y)) {
            const double relative = delta_e(a, b) / (contrast / edges);
            borders += 1 / std::sqrt(fair) / (1 + relative * relative * relative);
          }
        }
  double imbalance = 0;
  for (uint32_t i = 0; i < clusters.count(); ++i) {
    const double excess = static_cast<double>(clusters.area_px(i)) / fair - 1;
    imbalance += excess * excess;
  }
  return balance * imbalance + borders;
}

TEST(Cluster, EveryFragmentIsInOneConnectedClusterThatUnwraps) {
  for (uint32_t seed = 1; seed <= 10; ++seed) {
    const auto given = case_of(seed);
    const auto clusters = cluster_fragments(given.map, given.graph, given.packing);
    expect_whole(unwrap(idx_of(given, clusters)));
  }
}

TEST(Cluster, AreasAreThoseOfTheFragments) {
  const auto given = case_of(1);
  auto clusters = cluster_fragments(given.map, given.graph, given.packing);
  refine(clusters, given.map, given.graph);
  std::vector<uint64_t> areas(clusters.count(), 0);
  for (const uint32_t cluster : idx_of(given, clusters)) ++areas[cluster];
  for (uint32_t i = 0; i < clusters.count(); ++i) EXPECT_EQ(clusters.area_px(i), areas[i]);
}

TEST(Refine, LowersItsCostPassByPass) {
  for (uint32_t seed = 1; seed <= 10; ++seed) {
    const auto given = case_of(seed);
    auto clusters = cluster_fragments(given.map, given.graph, given.packing);
    const double before = cost(given, clusters, 4);
    refine(clusters, given.map, given.graph, 4, 1);
    const double between = cost(given, clusters, 4);
    refine(clusters, given.map, given.graph, 4, 30);
    const double after = cost(given, clusters, 4);
    EXPECT_LT(between, before) << "seed " << seed;
    EXPECT_LE(after, between + 1e-9) << "seed " << seed;
  }
}

TEST(Refine, KeepsClustersConnectedAndUnderHalfTheTile) {
  for (uint32_t seed = 1; seed <= 20; ++seed) {
    const auto given = case_of(seed, V2i(96, 96), 9);
    auto clusters = cluster_fragments(given.map, given.graph, given.packing);
    refine(clusters, given.map, given.graph, 0.01);  // borders alone: clusters eat each other where they can
    expect_whole(unwrap(idx_of(given, clusters)));
  }
}

TEST(Refine, MoreBalanceGivesMoreSimilarAreas) {
  const auto spread = [](double balance) {
    double sum = 0;
    for (uint32_t seed = 1; seed <= 5; ++seed) {
      const auto given = case_of(seed);
      auto clusters = cluster_fragments(given.map, given.graph, given.packing);
      refine(clusters, given.map, given.graph, balance);
      for (uint32_t i = 0; i < clusters.count(); ++i)
        sum += std::fabs(static_cast<double>(clusters.area_px(i)) - 128.0 * 96 / 14);
    }
    return sum;
  };
  EXPECT_LT(spread(10), spread(0.1));
}

}  // namespace
}  // namespace texbake
