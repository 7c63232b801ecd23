#include "libbake/content/choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "libbake/content/choice_figures.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

constexpr int kChoiceSize = 256;
constexpr int kChoicePatches = 9;

// Grain on a slow wave along x and y: what a border cannot see and the eye sees from afar.
Image<V3f> slow_waves() {
  Image<V3f> image(kChoiceSize, kChoiceSize);
  Random random(1);
  for (int y = 0; y < kChoiceSize; ++y)
    for (int x = 0; x < kChoiceSize; ++x)
      image(x, y) =
          V3f(50.0f + 15.0f * static_cast<float>(std::cos(2.0 * M_PI * x / kChoiceSize)) + 20.0f * random.uniform(),
              10.0f * static_cast<float>(std::sin(2.0 * M_PI * y / kChoiceSize)), 0.0f);
  return image;
}

// Candidates of nearly equal impact, those near the identity's phase of the waves first: what least impact falls for.
ContentCandidates candidates_near_first() {
  std::vector<Content> candidates;
  for (int i = 0; i < 40; ++i) {
    const int reach = 10 + 3 * i;
    candidates.push_back(make_content({i % 2 ? reach : -reach, i % 3 ? reach : -reach}, 0, 1.0f));
    candidates.back().impact = 1000.0f + static_cast<float>(i);
  }
  return ContentCandidates(kChoicePatches, candidates);
}

Partition patches_of_tile() {
  return twin::partition(twin::random_patches(kChoiceSize, kChoiceSize, kChoicePatches, 4), kChoicePatches);
}

ContentTable table(const ContentCandidates& candidates, const ChosenCandidates& chosen) {
  ContentTable result{kChoicePatches, static_cast<int>(chosen[0].size()) + 1, {}};
  for (size_t patch = 0; patch < chosen.size(); ++patch) {
    result.contents.emplace_back();
    for (const int number : chosen[patch]) result.contents.push_back(candidates[patch][static_cast<size_t>(number)]);
  }
  return result;
}

TEST(Choice, LeastImpactTakesTheFirstCandidates) {
  EXPECT_THAT(choose_least_impact(candidates_near_first(), 3), Each(ElementsAre(0, 1, 2)));
}

TEST(Choice, BalancedHidesTheGridThatLeastImpactKeeps) {
  const Image<V3f> luv = slow_waves();
  const Partition patches = patches_of_tile();
  const auto candidates = candidates_near_first();
  const auto least = choice_figures(table(candidates, choose_least_impact(candidates, 4)), luv, patches);
  const auto balanced =
      choice_figures(table(candidates, choose_balanced(candidates, 4, luv, patches, 1)), luv, patches);
  EXPECT_GT(least.repetition_far, 0.6);
  EXPECT_LT(balanced.repetition_far, 0.1);  // "good" of the quality measures
}

TEST(Choice, BalancedKeepsTheEnergyOfLargeShapes) {
  // The waves seen through the contents have about the energy of the tile: they are not washed out.
  const Image<V3f> luv = slow_waves();
  const Partition patches = patches_of_tile();
  const auto candidates = candidates_near_first();
  const auto chosen = table(candidates, choose_balanced(candidates, 4, luv, patches, 1));
  double shown = 0.0, own = 0.0;
  for (int y = 0; y < kChoiceSize; ++y)
    for (int x = 0; x < kChoiceSize; ++x)
      for (const Content& content : chosen.of(static_cast<int>(patches.idx(x, y)))) {
        const auto wave = [](int px) { return std::pow(std::cos(2.0 * M_PI * px / kChoiceSize), 2); };
        shown += wave(x + content.translation.x);
        own += wave(x);
      }
  EXPECT_NEAR(shown / own, 1.0, 0.15);
}

TEST(Choice, BalancedEvensOutTheUseOfTheExemplar) {
  // A constant tile, and for each patch other candidates at random.
  const Image<V3f> luv(kChoiceSize, kChoiceSize, V3f(50, 0, 0));
  const Partition patches = patches_of_tile();
  Random random(6);
  ContentCandidates candidates(kChoicePatches);
  for (auto& of_patch : candidates)
    for (int i = 0; i < 40; ++i) {
      of_patch.push_back(make_content(
          {static_cast<int>(random.below(kChoiceSize)), static_cast<int>(random.below(kChoiceSize))}, 0, 1.0f));
      of_patch.back().impact = 1000.0f + static_cast<float>(i);
    }
  const auto use = [&](const ChosenCandidates& chosen) {
    return choice_figures(table(candidates, chosen), luv, patches).use_deviation;
  };
  EXPECT_LT(use(choose_balanced(candidates, 4, luv, patches, 1)), 0.7 * use(choose_least_impact(candidates, 4)));
}

TEST(Choice, BalancedKeepsToLowImpactWhereTheRestIsEqual) {
  // A constant tile: only use and impact speak. Half of the candidates have ten times the impact of the others.
  auto candidates = candidates_near_first();
  for (auto& of_patch : candidates)
    for (size_t i = 20; i < 40; ++i) of_patch[i].impact = 10000.0f;
  const auto chosen =
      choose_balanced(candidates, 4, Image<V3f>(kChoiceSize, kChoiceSize, V3f(50, 0, 0)), patches_of_tile(), 1);
  EXPECT_THAT(chosen, Each(Each(::testing::Lt(20))));
}

TEST(Choice, BalancedKeepsBordersUnseenWhereAskedTo) {
  // A picture of faint vertical stripes eight texels apart, and candidates half of which move by whole stripes.
  Image<V3f> luv(kChoiceSize, kChoiceSize);
  Random grain(8);
  for (int y = 0; y < kChoiceSize; ++y)
    for (int x = 0; x < kChoiceSize; ++x) luv(x, y) = V3f((x / 4 % 2 ? 45.2f : 44.8f) + 0.05f * grain.uniform(), 0, 0);
  const Partition patches = patches_of_tile();
  Random random(9);
  ContentCandidates candidates(kChoicePatches);
  for (auto& of_patch : candidates)
    for (int i = 0; i < 40; ++i) {
      const int stripes = 8 * static_cast<int>(random.below(kChoiceSize / 8));
      of_patch.push_back(
          make_content({stripes + (i % 2 ? 4 : 0), static_cast<int>(random.below(kChoiceSize))}, 0, 1.0f));
      of_patch.back().impact = 1000.0f;
    }
  const auto broken_stripes = [&](const ChoiceWeights& weights) {
    int count = 0;
    for (const auto& of_patch : choose_balanced(candidates, 4, luv, patches, 1, weights))
      for (const int number : of_patch) count += number % 2;
    return count;
  };
  EXPECT_GT(broken_stripes({.steps = 0}), 12);  // 18 of 36 by chance
  EXPECT_EQ(broken_stripes({.steps = 10}), 0);
}

TEST(Choice, BalancedTakesDifferentCandidatesInOrderAndTheSameEveryTime) {
  const Image<V3f> luv = slow_waves();
  const Partition patches = patches_of_tile();
  const auto candidates = candidates_near_first();
  const auto chosen = choose_balanced(candidates, 4, luv, patches, 1);
  for (const auto& numbers : chosen) {
    EXPECT_EQ(std::set<int>(numbers.begin(), numbers.end()).size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(numbers));
  }
  EXPECT_EQ(choose_balanced(candidates, 4, luv, patches, 1), chosen);
}

TEST(Choice, TakesAllCandidatesWhereThereAreNoMore) {
  auto candidates = candidates_near_first();
  for (auto& of_patch : candidates) of_patch.resize(4);
  EXPECT_THAT(choose_balanced(candidates, 4, slow_waves(), patches_of_tile(), 1), Each(ElementsAre(0, 1, 2, 3)));
}

}  // namespace
}  // namespace texbake
