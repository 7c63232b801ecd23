#include "libbake/color/octree.h"

#include <gmock/gmock.h>

#include <set>

#include "tests/libbake/color/points.h"

namespace texbake {
namespace {

PointSet random_points(int count, int dimension) {
  Random random(11);
  PointSet points{.dimension = dimension, .coordinates = {}};
  for (int i = 0; i < count; ++i)
    points.append({100 * random.uniform(), 60 * random.uniform(), 80 * random.uniform(), 30 * random.uniform()});
  return points;
}

TEST(Octree, GivesAsManyDifferentColorsAsAsked) {
  for (const int dimension : {3, 4}) {
    const PointSet points = random_points(3000, dimension);
    for (const int count : {1, 2, 3, 5, 8, 17, 64}) {
      const std::vector<PointF> colors = octree_quantize(points, count, 1);
      EXPECT_EQ(std::set<PointF>(colors.begin(), colors.end()).size(), static_cast<size_t>(count));
    }
  }
}

TEST(Octree, KeepsColorsThatAreFewEnough) {
  const std::vector<PointF> colors{{10, 0, 0, 0}, {20, 30, 0, 0}, {90, 5, 40, 0}};
  PointSet points;
  for (int i = 0; i < 90; ++i) points.append(colors[static_cast<size_t>(i % 3)]);
  EXPECT_THAT(octree_quantize(points, 3, 1), testing::UnorderedElementsAreArray(colors));
  EXPECT_THAT(octree_quantize(points, 10, 1), testing::UnorderedElementsAreArray(colors));
}

TEST(Octree, OneColorIsTheMeanOfAll) {
  const PointSet points = point_set({{0, 0, 0, 0}, {10, 20, 30, 0}, {20, 40, 60, 0}, {90, 20, 30, 0}});
  const PointF mean = octree_quantize(points, 1, 0.25f).front();
  EXPECT_FLOAT_EQ(mean[0], 30);
  EXPECT_FLOAT_EQ(mean[1], 20);
  EXPECT_FLOAT_EQ(mean[2], 30);
}

TEST(Octree, SmallScaleGroupsByHueAndLargeScaleByLightness) {
  // Two hues 40 apart, each at two lightnesses 40 apart.
  Random random(2);
  PointSet points;
  for (const float l : {30.0f, 70.0f})
    for (const float u : {-20.0f, 20.0f}) add_cluster(points, random, {{l, u, 0, 0}, {}}, 200, 0, 1);
  const std::vector<PointF> hues = octree_quantize(points, 2, 0.25f), lights = octree_quantize(points, 2, 4);
  EXPECT_NEAR(std::abs(hues[0][1] - hues[1][1]), 40, 1);
  EXPECT_NEAR(std::abs(hues[0][0] - hues[1][0]), 0, 1);
  EXPECT_NEAR(std::abs(lights[0][0] - lights[1][0]), 40, 1);
  EXPECT_NEAR(std::abs(lights[0][1] - lights[1][1]), 0, 1);
}

TEST(Octree, OrderOfThePointsDoesNotMatter) {
  const PointSet points = random_points(500, 3);
  PointSet reversed;
  for (int i = points.size() - 1; i >= 0; --i) reversed.append(points.point(i));
  const auto forward = octree_quantize(points, 6, 1), backward = octree_quantize(reversed, 6, 1);
  for (size_t k = 0; k < forward.size(); ++k)
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(forward[k][c], backward[k][c], 1e-4f);  // sums round differently
}

TEST(Octree, EqualPointsGiveOneColor) {
  EXPECT_EQ(octree_quantize(point_set(std::vector<PointF>(50, {40, 3, 2, 0})), 4, 1),
            (std::vector<PointF>{{40, 3, 2, 0}}));
}

}  // namespace
}  // namespace texbake
