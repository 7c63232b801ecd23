#include "libbake/segment/fragment_graph.h"

#include <algorithm>
#include <cmath>

#include "libbake/color/luv.h"

namespace texbake {
namespace {

/// (from, to) of every edge between texels of two fragments, both ways, sorted.
std::vector<uint64_t> border_edges(const Image<uint32_t>& idx) {
  std::vector<uint64_t> edges;
  for (int y = 0; y < idx.height(); ++y)
    for (int x = 0; x < idx.width(); ++x)
      for (int n = 0; n < 2; ++n) {
        const uint64_t a = idx(x, y);
        const uint64_t b = idx(wrap(x + kNeighbourX[n], idx.width()), wrap(y + kNeighbourY[n], idx.height()));
        if (a == b) continue;
        edges.push_back(a << 32 | b);
        edges.push_back(b << 32 | a);
      }
  std::sort(edges.begin(), edges.end());
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

FragmentGraph fragment_graph(const FragmentMap& map) {
  FragmentGraph graph;
  graph.boxes = boxes_of(map.partition);
  std::vector<V3f> luv;
  for (const Fragment& fragment : map.fragments) luv.push_back(luv_from_linear(fragment.mean_color));

  const std::vector<uint64_t> edges = border_edges(map.partition.idx);
  graph.first.assign(graph.boxes.size() + 1, 0);
  for (size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end] == edges[begin]) ++end;
    const size_t from = edges[begin] >> 32, to = edges[begin] & 0xffffffffu;
    const V3f d = luv[from] - luv[to];
    graph.links.push_back(
        {static_cast<uint32_t>(to), static_cast<uint32_t>(end - begin), std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z)});
    graph.first[from + 1] = graph.links.size();
  }
  for (size_t f = 1; f < graph.first.size(); ++f) graph.first[f] = std::max(graph.first[f], graph.first[f - 1]);
  return graph;
}

}  // namespace texbake
