#include "libbake/color/line_kmeans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libbake/color/auto_classes.h"
#include "libbake/color/octree.h"
#include "tests/libbake/color/points.h"

namespace texbake {
namespace {

constexpr float kWeights[] = {0, 0.1f, 1};

PointSet random_points(int count, uint64_t seed, int dimension = 3) {
  Random random(seed);
  PointSet points{.dimension = dimension, .coordinates = {}};
  for (int i = 0; i < count; ++i)
    points.append({80 * random.uniform(), 90 * random.uniform() - 30, 50 * random.uniform(), 30 * random.uniform()});
  return points;
}

// Eq. 1 and its weighted form by the definition, with vectors.
double slow_cost(const PointF& point, const ColorLine& line, double along_weight) {
  double v = 0, squared = 0;
  for (size_t c = 0; c < 4; ++c) v += (static_cast<double>(point[c]) - line.point[c]) * line.direction[c];
  for (size_t c = 0; c < 4; ++c) {
    const double left = static_cast<double>(point[c]) - (line.point[c] + v * line.direction[c]);
    squared += left * left;
  }
  return squared + along_weight * v * v;
}

// The least cost of any division of the points into `classes` lines: all of them are tried.
double cost_of_best_division(const PointSet& points, int classes, double along_weight) {
  double least = std::numeric_limits<double>::infinity();
  int divisions = 1;
  for (int i = 0; i < points.size(); ++i) divisions *= classes;
  for (int division = 0; division < divisions; ++division) {
    std::vector<Moments> moments(static_cast<size_t>(classes));
    for (int i = 0, rest = division; i < points.size(); ++i, rest /= classes) {
      const PointF p = points.point(i);
      moments[static_cast<size_t>(rest % classes)].add<3>({p[0], p[1], p[2], 0});
    }
    double cost = 0;
    for (const Moments& m : moments) {
      if (m.count == 0) continue;
      const PrincipalAxis axis = principal_axis(m.covariance(), 3);
      cost += m.count * (axis.total - (1 - along_weight) * axis.variance);
    }
    least = std::min(least, cost / points.size());
  }
  return least;
}

double angle_between(const PointF& a, const PointF& b) {
  double product = 0;
  for (size_t c = 0; c < 4; ++c) product += static_cast<double>(a[c]) * b[c];
  return std::acos(std::min(1.0, std::fabs(product)));
}

TEST(LineKMeans, CostIsTheDistanceToTheLineAndTheWeightedCoordinate) {
  const PointSet points = random_points(100, 1);
  const ColorLine line{{40, 10, 20, 0}, {0.6f, 0, 0.8f, 0}};
  for (const float weight : kWeights)
    for (int i = 0; i < points.size(); ++i)  // float rounding of squares up to 1e4
      EXPECT_NEAR(line_cost(points.point(i), line, weight), slow_cost(points.point(i), line, weight), 4e-3);
}

TEST(LineKMeans, EveryPointGoesToTheNearestLine) {
  Random random(4);
  for (const int dimension : {3, 4})
    for (const float weight : kWeights) {
      const PointSet points = random_points(1500, 9, dimension);  // several lanes, the last one short
      std::vector<ColorLine> lines;
      for (int k = 0; k < 7; ++k) {
        const PointF p = points.point(k * 31);
        lines.push_back({p, k % 3 ? PointF{0.6f, -0.8f, 0, 0} : PointF{}});
      }
      std::vector<uint8_t> labels(1500);
      assign_to_lines(points.data(), dimension, 1500, lines, weight, labels.data());
      for (int i = 0; i < 1500; ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (const ColorLine& line : lines) least = std::min(least, slow_cost(points.point(i), line, weight));
        const ColorLine& chosen = lines[labels[static_cast<size_t>(i)]];
        EXPECT_LE(slow_cost(points.point(i), chosen, weight), least + 4e-3);  // float rounding, as above
      }
    }
}

TEST(LineKMeans, LowestIndexWinsTies) {
  const PointSet points = random_points(600, 2);
  const ColorLine line{{40, 10, 20, 0}, {1, 0, 0, 0}};
  const std::vector<ColorLine> lines{line, line, line};
  std::vector<uint8_t> labels(600, 77);
  assign_to_lines(points.data(), 3, 600, lines, 0, labels.data());
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0), 600);
}

TEST(LineKMeans, CostNeverIncreases) {
  for (const float weight : kWeights)
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const PointSet points = random_points(400, seed, seed % 2 ? 3 : 4);
      const auto starts = octree_quantize(points, 6, 1);
      const LineKMeansResult result =
          line_kmeans(points, starts, {.along_weight = weight, .max_iterations = 60, .least_gain = 0});
      for (size_t i = 1; i < result.costs.size(); ++i)
        EXPECT_LE(result.costs[i], result.costs[i - 1] * (1 + 1e-6));  // lines are rounded to float
    }
}

TEST(LineKMeans, CostIsWhatTheLabelsAndLinesSay) {
  const PointSet points = random_points(300, 8);
  for (const float weight : kWeights) {
    const auto starts = octree_quantize(points, 4, 1);
    const LineKMeansResult result = line_kmeans(points, starts, {.along_weight = weight});
    double cost = 0, squared_error = 0;
    for (int i = 0; i < points.size(); ++i) {
      const ColorLine& line = result.lines[result.labels[static_cast<size_t>(i)]];
      cost += slow_cost(points.point(i), line, weight) / points.size();
      squared_error += slow_cost(points.point(i), line, 0) / points.size();
    }
    EXPECT_NEAR(result.costs.back(), cost, 1e-4 * cost);
    EXPECT_NEAR(result.squared_error, squared_error, 1e-4 * squared_error);
  }
}

TEST(LineKMeans, NeverBeatsTheBestDivision) {
  for (const float weight : kWeights)
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const PointSet points = random_points(9, 100 + seed);
      EXPECT_GE(best_lines(points, 2, weight).costs.back(),
                cost_of_best_division(points, 2, weight) * (1 - 1e-4) - 1e-4);
    }
}

TEST(LineKMeans, FindsTheBestDivisionOfTwoStreaks) {
  int found = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    PointSet points;
    add_cluster(points, random, {{30, 20, 5, 0}, {0.6f, 0.8f, 0, 0}}, 5, 6, 1);
    add_cluster(points, random, {{50, -20, 20, 0}, {0.8f, 0, 0.6f, 0}}, 4, 6, 1);
    for (const float weight : kWeights)
      if (best_lines(points, 2, weight).costs.back() <= cost_of_best_division(points, 2, weight) * 1.001 + 1e-4)
        ++found;
  }
  // Nine points leave eq. 1 alone (weight 0) many ways to draw two lines through most of them.
  EXPECT_GE(found, 50);
}

TEST(LineKMeans, PlantedLinesAreRecovered) {
  const ColorLine planted[] = {{{30, 40, 10, 0}, {0.6f, 0.8f, 0, 0}},
                               {{60, -30, 20, 0}, {0.8f, 0, 0.6f, 0}},
                               {{50, 30, -60, 0}, {0, 0.6f, -0.8f, 0}}};
  Random random(6);
  PointSet points;
  for (const ColorLine& line : planted) add_cluster(points, random, line, 2000, 8, 0.5f);
  for (const float weight : {0.0f, 0.1f}) {
    const LineKMeansResult result = best_lines(points, 3, weight);
    for (const ColorLine& line : planted) {
      const auto nearest = std::min_element(
          result.lines.begin(), result.lines.end(),
          [&](const auto& a, const auto& b) { return slow_cost(line.point, a, 1) < slow_cost(line.point, b, 1); });
      EXPECT_LT(std::sqrt(slow_cost(line.point, *nearest, 1)), 0.8);  // 4 · 8/√2000: four standard errors of the mean
      EXPECT_LT(angle_between(line.direction, nearest->direction), 0.01);
    }
    EXPECT_NEAR(result.squared_error, 2 * 0.25, 0.03);  // two coordinates across, variance ¼ each
  }
}

TEST(LineKMeans, EmptyClassTakesTheWorstPoint) {
  Random random(1);
  PointSet points;
  add_cluster(points, random, {{40, 0, 0, 0}, {}}, 300, 0, 1);
  points.append({90, 60, 0, 0});
  // The second start is nobody's nearest.
  const std::vector<PointF> starts{{40, 0, 0, 0}, {-900, 0, 0, 0}};
  const LineKMeansResult result = line_kmeans(points, starts, {.along_weight = 0.1f});
  EXPECT_EQ(result.labels.back(), 1);
  EXPECT_EQ(result.lines[1].point, (PointF{90, 60, 0, 0}));
}

TEST(LineKMeans, EveryClassIsUsedWhenThereAreEnoughColors) {
  Random random(12);
  PointSet points;
  for (int i = 0; i < 500; ++i)
    points.append({static_cast<float>(10 * random.below(4)), static_cast<float>(20 * random.below(4)), 5, 0});
  for (const int classes : {2, 7, 16}) {
    const LineKMeansResult result = best_lines(points, classes, 0.1f);
    for (int k = 0; k < classes; ++k)
      EXPECT_GT(std::count(result.labels.begin(), result.labels.end(), k), 0) << classes << " " << k;
  }
  EXPECT_NEAR(best_lines(points, 16, 0.1f).costs.back(), 0, 1e-6);  // one class for each of the sixteen colors
}

TEST(LineKMeans, GrayPointsAreDividedByLightnessUnlessOnlyEquationOneCounts) {
  PointSet points;
  for (int i = 0; i < 1000; ++i) points.append({0.1f * static_cast<float>(i), 0, 0, 0});
  const LineKMeansResult result = best_lines(points, 4, 0.1f);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(static_cast<double>(std::count(result.labels.begin(), result.labels.end(), k)), 250, 40);
  EXPECT_NEAR(result.squared_error, 0, 1e-6);
  EXPECT_NEAR(best_lines(points, 4, 0).squared_error, 0, 1e-6);
}

}  // namespace
}  // namespace texbake
