#include "libbake/height/heightmap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/error.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

PrincipalVariation one_class(Image<float> variation) {
  PrincipalVariation colors;
  colors.palette.classes.resize(1);
  colors.index = Image<uint8_t>(variation.width(), variation.height());
  colors.variation = std::move(variation);
  return colors;
}

// Round bumps of radius 6 on a 16-texel grid: v falls from the middle to the rim as the height does.
Image<float> bumps(int n) {
  Image<float> image(n, n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const double dx = x % 16 - 7.5;
      const double dy = y % 16 - 7.5;
      image(x, y) = static_cast<float>(std::max(0.0, 1.0 - (dx * dx + dy * dy) / 36.0));
    }
  return image;
}

double correlation(const Image<float>& a, const Image<float>& b) {
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  const auto n = static_cast<double>(a.size());
  for (size_t i = 0; i < a.size(); ++i) {
    const double u = a.data()[i];
    const double v = b.data()[i];
    sa += u, sb += v, saa += u * u, sbb += v * v, sab += u * v;
  }
  return (sab / n - sa * sb / n / n) / std::sqrt((saa / n - sa * sa / n / n) * (sbb / n - sb * sb / n / n));
}

TEST(Heightmap, OneClickGivesAConstantHeight) {
  const Heightmap map = heightmap(one_class(bumps(48)), {{{3, 4}, 0.7f}});
  for (const float h : map.height_01) EXPECT_EQ(h, 0.7f);
}

TEST(Heightmap, AClickedTexelHasItsHeight) {
  const std::vector<HeightClick> clicks = {{{8, 8}, 0.9f}, {{0, 0}, 0.1f}, {{11, 8}, 0.4f}};
  const Heightmap map = heightmap(one_class(bumps(48)), clicks);
  for (const HeightClick& click : clicks) EXPECT_EQ(map.height_01(click.texel.x, click.texel.y), click.height_01);
}

TEST(Heightmap, HeightsOfOneBumpSpreadToAllBumps) {
  const Image<float> truth = bumps(64);
  std::vector<HeightClick> clicks;
  for (int y = 1; y < 16; y += 3)
    for (int x = 1; x < 16; x += 3) clicks.push_back({{x, y}, truth(x, y)});
  EXPECT_GT(correlation(heightmap(one_class(bumps(64)), clicks).height_01, truth), 0.85);
}

TEST(Heightmap, EachClassListensToItsOwnClicks) {
  PrincipalVariation colors = one_class(bumps(32));
  colors.palette.classes.resize(2);
  for (int y = 0; y < 32; ++y)
    for (int x = 16; x < 32; ++x) colors.index(x, y) = 1;
  const Heightmap map = heightmap(colors, {{{3, 3}, 0.2f}, {{20, 3}, 0.8f}});
  EXPECT_EQ(map.height_01(10, 20), 0.2f);
  EXPECT_EQ(map.height_01(25, 20), 0.8f);
  EXPECT_TRUE(map.classes_without_click.empty());
}

TEST(Heightmap, AClassWithoutAClickIsReportedAndUsesAllClicks) {
  PrincipalVariation colors = one_class(bumps(32));
  colors.palette.classes.resize(2);
  for (int y = 0; y < 32; ++y)
    for (int x = 16; x < 32; ++x) colors.index(x, y) = 1;
  const Heightmap map = heightmap(colors, {{{3, 3}, 0.2f}});
  EXPECT_EQ(map.classes_without_click, std::vector<int>{1});
  EXPECT_EQ(map.height_01(25, 20), 0.2f);
}

TEST(Heightmap, ManyClicksAreReducedToRepresentatives) {
  const Image<float> truth = bumps(48);
  std::vector<HeightClick> strokes;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) strokes.push_back({{x, y}, truth(x, y)});
  const Heightmap map = heightmap(one_class(bumps(48)), strokes, {.max_representatives = 20});
  EXPECT_EQ(map.clicks_used, 20);
  EXPECT_GT(correlation(map.height_01, truth), 0.9);
}

TEST(Heightmap, RefusesWhatMakesNoSense) {
  const PrincipalVariation colors = one_class(bumps(32));
  EXPECT_THROW(heightmap(colors, {}), Error);
  EXPECT_THROW(heightmap(colors, {{{32, 0}, 0.5f}}), Error);
  EXPECT_THROW(heightmap(colors, {{{0, 0}, 1.5f}}), Error);
  EXPECT_THROW(heightmap(colors, {{{0, 0}, NAN}}), Error);
  EXPECT_THROW(heightmap(colors, {{{1, 1}, 0.5f}, {{1, 1}, 0.6f}}), Error);
  EXPECT_NO_THROW(heightmap(colors, {{{1, 1}, 0.5f}, {{1, 1}, 0.5f}}));
}

}  // namespace
}  // namespace texbake
