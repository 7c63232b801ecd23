#include "libbake/height/heightmap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/error.h"
#include "libbake/height/shading.h"
#include "tests/libbake/height/known_height.h"
#include "tests/libbake/height/obvious_heights.h"

namespace texbake {
namespace {

// Shades of gray about L = 50: the variation is the difference in L.
PrincipalVariation one_class(const Image<float>& variation) {
  PrincipalVariation colors;
  colors.palette.classes = {{V3f(50, 0, 0), V3f(1, 0, 0)}};
  colors.index = Image<uint8_t>(variation.width(), variation.height());
  colors.variation = variation.clone();
  return colors;
}

// A second class, painted alike, from column `x` on.
PrincipalVariation two_classes(const Image<float>& variation, int x) {
  PrincipalVariation colors = one_class(variation);
  colors.palette.classes.push_back(colors.palette.classes[0]);
  for (int y = 0; y < variation.height(); ++y)
    for (int i = x; i < variation.width(); ++i) colors.index(i, y) = 1;
  return colors;
}

// Round bumps of radius 6 on a 16-texel grid, 0 … 1.
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

// The same bumps as light: up to 20 ΔE brighter on top.
Image<float> light_of_bumps(int n) {
  Image<float> image = bumps(n);
  for (float& value : image) value *= 20.0f;
  return image;
}

Heightmap heights(const PrincipalVariation& colors, const std::vector<HeightClick>& clicks,
                  const HeightmapOptions& options = {}) {
  return heightmap(colors, decode(colors), clicks, options);
}

class HeightmapOfEither : public ::testing::TestWithParam<HeightDescriptor> {
 protected:
  HeightmapOfEither() { options.descriptor = GetParam(); }
  HeightmapOptions options;
};
INSTANTIATE_TEST_SUITE_P(Descriptors, HeightmapOfEither,
                         ::testing::Values(HeightDescriptor::appearance, HeightDescriptor::gradients),
                         [](const auto& test) { return std::string(enum_name(test.param)); });

TEST_P(HeightmapOfEither, OneClickGivesAConstantHeight) {
  for (const float h : heights(one_class(light_of_bumps(48)), {{{3, 4}, 0.7f}}, options).height_01) EXPECT_EQ(h, 0.7f);
}

TEST_P(HeightmapOfEither, AClickedTexelHasItsHeight) {
  const std::vector<HeightClick> clicks = {{{8, 8}, 0.9f}, {{0, 0}, 0.1f}, {{11, 8}, 0.4f}};
  options.refine = 0.0f;
  const Heightmap map = heights(one_class(light_of_bumps(48)), clicks, options);
  for (const HeightClick& click : clicks) EXPECT_EQ(map.height_01(click.texel.x, click.texel.y), click.height_01);
}

TEST_P(HeightmapOfEither, HeightsOfOneBumpSpreadToAllBumps) {
  const Image<float> truth = bumps(64);
  std::vector<HeightClick> clicks;
  for (int y = 1; y < 16; y += 3)
    for (int x = 1; x < 16; x += 3) clicks.push_back({{x, y}, truth(x, y)});
  EXPECT_GT(correlation(heights(one_class(light_of_bumps(64)), clicks, options).height_01, truth), 0.85);
}

TEST_P(HeightmapOfEither, HeightsStayBetweenThoseOfTheClicks) {
  const Image<float> truth = bumps(64);
  const auto clicks = twin::random_clicks(truth, 12, 3);
  const auto [least, most] = std::ranges::minmax(clicks, {}, &HeightClick::height_01);
  for (const float h : heights(one_class(light_of_bumps(64)), clicks, options).height_01) {
    EXPECT_GE(h, least.height_01);
    EXPECT_LE(h, most.height_01);
  }
}

TEST_P(HeightmapOfEither, ManyClicksAreReducedToRepresentatives) {
  const Image<float> truth = bumps(48);
  std::vector<HeightClick> strokes;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) strokes.push_back({{x, y}, truth(x, y)});
  options.max_representatives = 20;
  const Heightmap map = heights(one_class(light_of_bumps(48)), strokes, options);
  EXPECT_EQ(map.clicks_used, 20);
  EXPECT_GT(correlation(map.height_01, truth), 0.9);
}

TEST_P(HeightmapOfEither, RefusesWhatMakesNoSense) {
  const PrincipalVariation colors = one_class(light_of_bumps(32));
  EXPECT_THROW(heights(colors, {}, options), Error);
  EXPECT_THROW(heights(colors, {{{32, 0}, 0.5f}}, options), Error);
  EXPECT_THROW(heights(colors, {{{0, 0}, 1.5f}}, options), Error);
  EXPECT_THROW(heights(colors, {{{0, 0}, NAN}}, options), Error);
  EXPECT_THROW(heights(colors, {{{1, 1}, 0.5f}, {{1, 1}, 0.6f}}, options), Error);
  EXPECT_NO_THROW(heights(colors, {{{1, 1}, 0.5f}, {{1, 1}, 0.5f}}, options));
}

TEST(Heightmap, EqualsTheObviousLoop) {
  const Image<float> truth = bumps(48);
  const PrincipalVariation colors = one_class(light_of_bumps(48));
  HeightmapOptions options;
  options.refine = 0.0f;
  for (const int count : {1, 2, 3, 10, 40}) {
    const auto clicks = twin::random_clicks(truth, count, 7);
    const Image<float> found = heights(colors, clicks, options).height_01;
    const Image<float> expected = twin::obvious_heights(decode(colors), clicks);
    for (size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found.data()[i], expected.data()[i], 1e-6) << count;  // weights are scaled before they are summed
  }
}

TEST(Heightmap, TheValuesOfThePaperComeWithItsDescriptor) {
  HeightmapOptions options;
  EXPECT_EQ(resolve(options).nearest, 8);
  EXPECT_EQ(resolve(options).falloff, 2);
  options.descriptor = HeightDescriptor::gradients;
  EXPECT_EQ(resolve(options).nearest, 3);
  EXPECT_EQ(resolve(options).falloff, 1);
  EXPECT_EQ(resolve(options).refine, 0.0f);
}

TEST(Heightmap, WithGradientsEachClassListensToItsOwnClicks) {
  HeightmapOptions options;
  options.descriptor = HeightDescriptor::gradients;
  const Heightmap map = heights(two_classes(light_of_bumps(32), 16), {{{3, 3}, 0.2f}, {{20, 3}, 0.8f}}, options);
  EXPECT_EQ(map.height_01(10, 20), 0.2f);
  EXPECT_EQ(map.height_01(25, 20), 0.8f);
  EXPECT_TRUE(map.classes_without_click.empty());
}

TEST(Heightmap, WithGradientsAClassWithoutAClickGoesByAppearance) {
  HeightmapOptions options;
  options.descriptor = HeightDescriptor::gradients;
  options.nearest = 1;
  const PrincipalVariation colors = two_classes(light_of_bumps(32), 16);
  const std::vector<HeightClick> clicks = {{{7, 7}, 0.9f}, {{0, 0}, 0.1f}};
  const Heightmap map = heights(colors, clicks, options);
  EXPECT_EQ(map.classes_without_click, std::vector<int>{1});
  options.descriptor = HeightDescriptor::appearance;
  options.refine = 0.0f;
  const Heightmap by_appearance = heights(colors, clicks, options);
  for (int y = 0; y < 32; ++y)
    for (int x = 16; x < 32; ++x) EXPECT_EQ(map.height_01(x, y), by_appearance.height_01(x, y));
}

TEST(Heightmap, TenClicksRecoverCracksThatLookDark) {
  // Flat cells between cracks 5 texels wide, 12 ΔE darker, under grain of 4 ΔE: the paper's gradients see the rims of
  // the cracks, not that they are dark.
  const int n = 128;
  Image<float> truth(n, n), light(n, n);
  Random random(9);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      truth(x, y) = x % 32 < 5 || (y + 16 * (x / 32)) % 32 < 5 ? 0.1f : 0.8f;
      light(x, y) = (truth(x, y) < 0.5f ? -12.0f : 0.0f) + 4 * std::sqrt(12.0f) * (random.uniform() - 0.5f);
    }
  const PrincipalVariation colors = one_class(light);
  HeightmapOptions paper;
  paper.descriptor = HeightDescriptor::gradients;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const auto clicks = twin::chosen_clicks(truth, 10, seed);
    const double by_appearance = correlation(heights(colors, clicks).height_01, truth);
    EXPECT_GT(by_appearance, 0.7) << seed;
    EXPECT_GT(by_appearance, correlation(heights(colors, clicks, paper).height_01, truth)) << seed;
  }
}

}  // namespace
}  // namespace texbake
