// Obvious, independent ways to look at a partition: union-find for pieces, repeated relaxation for unwrapping.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "libbake/segment/partition.h"

namespace texbake {

/// Number of 4-connected pieces of equal `idx` on the torus.
inline int count_pieces(const Image<uint32_t>& idx) {
  std::vector<size_t> parent(idx.size());
  std::iota(parent.begin(), parent.end(), size_t{0});
  const auto root = [&](size_t a) {
    while (parent[a] != a) a = parent[a] = parent[parent[a]];
    return a;
  };
  const int width = idx.width(), height = idx.height();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto at = [&](int i, int j) { return static_cast<size_t>(j % height * width + i % width); };
      if (idx(x, y) == idx((x + 1) % width, y)) parent[root(at(x, y))] = root(at(x + 1, y));
      if (idx(x, y) == idx(x, (y + 1) % height)) parent[root(at(x, y))] = root(at(x, y + 1));
    }
  std::set<size_t> roots;
  for (size_t a = 0; a < parent.size(); ++a) roots.insert(root(a));
  return static_cast<int>(roots.size());
}

/// Number of distinct values.
inline int count_shapes(const Image<uint32_t>& idx) {
  return static_cast<int>(std::set<uint32_t>(idx.begin(), idx.end()).size());
}

/// The laws of Partition, each looked at in the most obvious way.
inline void expect_whole(const Partition& partition) {
  const int width = partition.idx.width(), height = partition.idx.height();
  ASSERT_TRUE(same_size(partition.idx, partition.owner));
  ASSERT_EQ(partition.areas_px.size(), partition.centers.size());
  EXPECT_EQ(count_shapes(partition.idx), partition.count());
  EXPECT_EQ(count_pieces(partition.idx), partition.count()) << "a shape is in several pieces";
  std::vector<std::vector<V2i>> texels(partition.centers.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const uint32_t shape = partition.idx(x, y);
      ASSERT_LT(shape, texels.size());
      const V2i u(x - partition.owner(x, y).x * width, y - partition.owner(x, y).y * height);
      texels[shape].push_back(u);
      const int right = (x + 1) % width, below = (y + 1) % height;
      if (partition.idx(right, y) == shape) {
        EXPECT_EQ(right - partition.owner(right, y).x * width, u.x + 1) << "at " << x << ", " << y;
      }
      if (partition.idx(x, below) == shape) {
        EXPECT_EQ(below - partition.owner(x, below).y * height, u.y + 1) << "at " << x << ", " << y;
      }
    }
  for (size_t shape = 0; shape < texels.size(); ++shape) {
    ASSERT_FALSE(texels[shape].empty());
    EXPECT_EQ(texels[shape].size(), partition.areas_px[shape]);
    V2i low = texels[shape][0], high = low;
    double sum_x = 0, sum_y = 0;
    for (const V2i& u : texels[shape]) {
      low = {std::min(low.x, u.x), std::min(low.y, u.y)};
      high = {std::max(high.x, u.x), std::max(high.y, u.y)};
      sum_x += u.x;
      sum_y += u.y;
    }
    EXPECT_LT(2 * (high.x - low.x + 1), width) << "shape " << shape;
    EXPECT_LT(2 * (high.y - low.y + 1), height) << "shape " << shape;
    const auto area = static_cast<double>(texels[shape].size());
    EXPECT_EQ(partition.centers[shape].x, static_cast<int>(std::floor(sum_x / area + 0.5)));
    EXPECT_EQ(partition.centers[shape].y, static_cast<int>(std::floor(sum_y / area + 0.5)));
    EXPECT_EQ(wrap(partition.centers[shape], V2i(width, height)), partition.centers[shape]);
  }
}

}  // namespace texbake
