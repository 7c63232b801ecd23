#include "libbake/segment/fragment_graph.h"

#include <algorithm>
#include <cmath>

namespace texbake {
namespace {

/// One edge between texels of two fragments, seen from one of them.
struct Edge {
  uint64_t from_to;
  float step;
};

/// Every edge, both ways, by (from, to), then in row order.
std::vector<Edge> border_edges(const Image<uint32_t>& idx, ImageView<const V3f> luv) {
  std::vector<Edge> edges;
  for (int y = 0; y < idx.height(); ++y)
    for (int x = 0; x < idx.width(); ++x)
      for (int n = 0; n < 2; ++n) {
        const V2i q(wrap(x + kNeighborX[n], idx.width()), wrap(y + kNeighborY[n], idx.height()));
        const uint64_t a = idx(x, y), b = idx(q.x, q.y);
        if (a == b) continue;
        const V3f d = luv(x, y) - luv(q.x, q.y);
        const float step = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        edges.push_back({a << 32 | b, step});
        edges.push_back({b << 32 | a, step});
      }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.from_to < b.from_to; });
  return edges;
}

std::vector<TorusBox> boxes_of(const Partition& partition) {
  const V2i size = partition.size();
  std::vector<V2i> low(partition.centers), high(partition.centers);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const uint32_t shape = partition.idx(x, y);
      const V2i u = partition.unwrapped(x, y);
      low[shape] = {std::min(low[shape].x, u.x), std::min(low[shape].y, u.y)};
      high[shape] = {std::max(high[shape].x, u.x), std::max(high[shape].y, u.y)};
    }
  std::vector<TorusBox> boxes;
  for (size_t shape = 0; shape < low.size(); ++shape)
    boxes.push_back({wrap(low[shape], size), V2i(high[shape].x - low[shape].x + 1, high[shape].y - low[shape].y + 1)});
  return boxes;
}

}  // namespace

FragmentGraph fragment_graph(const FragmentMap& map, ImageView<const V3f> luv) {
  FragmentGraph graph;
  graph.boxes = boxes_of(map.partition);
  const std::vector<Edge> edges = border_edges(map.partition.idx, luv);
  graph.first.assign(graph.boxes.size() + 1, 0);
  for (size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    double sum = 0;
    for (; end < edges.size() && edges[end].from_to == edges[begin].from_to; ++end)
      sum += static_cast<double>(edges[end].step);
    const size_t from = edges[begin].from_to >> 32, to = edges[begin].from_to & 0xffffffffu;
    const size_t length = end - begin;
    graph.links.push_back({static_cast<uint32_t>(to), static_cast<uint32_t>(length),
                           static_cast<float>(sum / static_cast<double>(length))});
    graph.first[from + 1] = graph.links.size();
  }
  for (size_t f = 1; f < graph.first.size(); ++f) graph.first[f] = std::max(graph.first[f], graph.first[f - 1]);
  return graph;
}

}  // namespace texbake
