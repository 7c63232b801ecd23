#include "libbake/height/click_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbake {
namespace {

// A line of places, which are as far from each other as their numbers.
float on_a_line(const float* a, const float* b) { return std::abs(*a - *b); }
constexpr DescriptorSpace kLine = {1, on_a_line};

ClickSet clicks(std::initializer_list<std::pair<float, float>> place_and_height) {
  ClickSet set(kLine, 1);
  for (const auto& [place, height] : place_and_height) set.add(height, {place});
  return set;
}

float height_at(const ClickSet& set, float place, const Blend& blend) { return set.height_of(&place, blend); }

TEST(ClickSet, HeightsAreBlendedByInverseDistance) {
  ClickSet set = clicks({{0, 0.0f}, {3, 1.0f}});
  set.build();
  EXPECT_FLOAT_EQ(height_at(set, 1, {2, 1}), 1.0f / 3);  // weights 1 and 1/2
  EXPECT_FLOAT_EQ(height_at(set, 1, {2, 2}), 1.0f / 5);  // weights 1 and 1/4
}

TEST(ClickSet, OnlyTheNearestCount) {
  ClickSet set = clicks({{0, 0.2f}, {1, 0.4f}, {100, 1.0f}});
  set.build();
  EXPECT_FLOAT_EQ(height_at(set, 0.5f, {2, 1}), 0.3f);
  EXPECT_FLOAT_EQ(height_at(set, 80, {1, 1}), 1.0f);
}

TEST(ClickSet, AClickAtDistanceZeroDecidesAlone) {
  ClickSet set = clicks({{0, 0.2f}, {1, 0.4f}});
  set.build();
  EXPECT_EQ(height_at(set, 1, {2, 1}), 0.4f);
}

TEST(ClickSet, ThoseThatDifferMostAreKept) {
  ClickSet set = clicks({{0, 0.1f}, {1, 0.2f}, {10, 0.3f}, {4, 0.4f}, {9, 0.5f}});
  set.reduce(3);  // the first, then 10, then 4
  ASSERT_EQ(set.count(), 3);
  set.build();
  EXPECT_EQ(height_at(set, 1, {1, 1}), 0.1f);
  EXPECT_EQ(height_at(set, 9, {1, 1}), 0.3f);
  EXPECT_EQ(height_at(set, 5, {1, 1}), 0.4f);
}

TEST(ClickSet, TheNearestTurnOfAClickCounts) {
  ClickSet set(kLine, 2);
  set.add(0.25f, {0, 50});
  set.add(0.75f, {10, 20});
  set.build();
  EXPECT_EQ(height_at(set, 40, {1, 1}), 0.25f);
  EXPECT_FLOAT_EQ(height_at(set, 30, {2, 1}), 0.58333333f);  // distances 20 and 10
}

}  // namespace
}  // namespace texbake
