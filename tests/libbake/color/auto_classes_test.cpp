#include "libbake/color/auto_classes.h"

#include <gtest/gtest.h>

#include "libbake/color/octree.h"
#include "tests/libbake/color/points.h"

namespace texbake {
namespace {

// Clusters on a ring of radius 40 around gray, at two lightnesses, every direction different.
PointSet planted_clusters(int count, float along, float across) {
  constexpr float kRing[8][2] = {{40, 0}, {28, 28}, {0, 40}, {-28, 28}, {-40, 0}, {-28, -28}, {0, -40}, {28, -28}};
  Random random(21);
  PointSet points;
  for (int k = 0; k < count; ++k) {
    const float* hue = kRing[(3 * k) % 8];
    const ColorLine line{{k % 2 ? 65.0f : 35.0f, hue[0], hue[1], 0}, {1, 0, 0, 0}};
    add_cluster(points, random, line, 300, along, across);
  }
  return points;
}

TEST(AutoClasses, PlantedClustersAreCounted) {
  for (int planted = 3; planted <= 8; ++planted) {
    EXPECT_EQ(best_lines_of_auto_count(planted_clusters(planted, 4, 2), 0.1f).lines.size(),
              static_cast<size_t>(planted));
    EXPECT_EQ(best_lines_of_auto_count(planted_clusters(planted, 1, 1), 0.1f).lines.size(),
              static_cast<size_t>(planted));
  }
}

TEST(AutoClasses, FewerColorsThanThreeAreEachAClass) {
  EXPECT_EQ(best_lines_of_auto_count(point_set(std::vector<PointF>(100, {50, 1, 1, 0})), 0.1f).lines.size(), 1u);
  std::vector<PointF> two(100, {50, 1, 1, 0});
  two[40] = {20, 5, 5, 0};
  EXPECT_EQ(best_lines_of_auto_count(point_set(two), 0.1f).lines.size(), 2u);
}

TEST(AutoClasses, WhatCannotBeSeenIsNotDivided) {
  Random random(3);
  PointSet points;
  add_cluster(points, random, {{50, 5, 5, 0}, {1, 0, 0, 0}}, 1000, 0.5f, 0.3f);
  EXPECT_EQ(best_lines_of_auto_count(points, 0.1f).lines.size(), 3u);
}

TEST(AutoClasses, StructurelessColorsGetFewClasses) {
  Random random(3);
  PointSet points;
  add_cluster(points, random, {{50, 5, 5, 0}, {1, 0, 0, 0}}, 2000, 20, 10);
  const size_t classes = best_lines_of_auto_count(points, 0.1f).lines.size();
  EXPECT_GE(classes, 3u);
  EXPECT_LE(classes, 5u);
}

TEST(AutoClasses, TheBestOfTheStartsIsKept) {
  const PointSet points = planted_clusters(6, 6, 3);
  const double best = best_lines(points, 6, 0.1f).costs.back();
  for (const float scale : {0.125f, 0.25f, 0.5f, 1.0f, 2.0f, 4.0f}) {
    const LineKMeansResult one =
        line_kmeans(points, octree_quantize(points, 6, scale), {.along_weight = 0.1f, .max_iterations = 100});
    EXPECT_LE(best, one.costs.back() * 1.01);  // the search compares before the last percent is gained
  }
}

}  // namespace
}  // namespace texbake
