#include "libbake/content/class_distances.h"

#include <gtest/gtest.h>

#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

TEST(ClassDistances, TheFarthestTwoClassesSpanAllSteps) {
  const V3f colors[] = {{0, 0, 0}, {30, 40, 0}, {30, 0, 0}};  // ΔE² 2500, 900, 1600
  const ClassDistances distances = class_distances(colors);
  EXPECT_EQ(distances.at(0, 1), kMaxDistanceSteps);
  EXPECT_DOUBLE_EQ(distances.step, 2500.0 / 255.0);
  EXPECT_EQ(distances.at(0, 2), 92);   // 91.8
  EXPECT_EQ(distances.at(2, 1), 163);  // 163.2
}

TEST(ClassDistances, AreSymmetricAndWithinHalfAStepOfTheSquaredDistance) {
  const std::vector<V3f> colors = twin::random_colors(20, 3);
  const ClassDistances distances = class_distances(colors);
  for (int a = 0; a < 20; ++a) {
    EXPECT_EQ(distances.at(a, a), 0);
    for (int b = 0; b < 20; ++b) {
      EXPECT_EQ(distances.at(a, b), distances.at(b, a));
      const V3f d = colors[static_cast<size_t>(a)] - colors[static_cast<size_t>(b)];
      // Half a step, and the rounding of the float squares here.
      EXPECT_NEAR(distances.at(a, b) * distances.step, static_cast<double>(d.length2()), 0.501 * distances.step);
    }
  }
}

TEST(ClassDistances, ClassesOfOneColorAreAtNoDistance) {
  const V3f colors[] = {{50, 1, 2}, {50, 1, 2}};
  EXPECT_EQ(class_distances(colors).at(0, 1), 0);
}

TEST(ClassDistances, ImpactIsTheMeanErrorInSquaredSquares) {
  ClassDistances distances;
  distances.step = 4.0;
  EXPECT_DOUBLE_EQ(distances.impact(100, 50), 100 * 16.0 / 50);
  EXPECT_DOUBLE_EQ(distances.impact(0, 0), 0.0);
}

}  // namespace
}  // namespace texbake
