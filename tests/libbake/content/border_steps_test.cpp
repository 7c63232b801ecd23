#include "libbake/content/border_steps.h"

#include <gtest/gtest.h>

#include "libbake/content/shown_source.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

constexpr int kStepsSize = 48;  // every border of two patches is shorter than the number of pairs that is looked at
constexpr int kStepsPatches = 6;

Image<V3f> grain(uint32_t seed) {
  Image<V3f> luv(kStepsSize, kStepsSize);
  Random random(seed);
  for (V3f& c : luv) c = V3f(30 + 20 * random.uniform(), 10 * random.uniform(), 10 * random.uniform());
  return luv;
}

std::vector<std::vector<Content>> random_contents(int count, uint32_t seed) {
  Random random(seed);
  std::vector<std::vector<Content>> contents(kStepsPatches, std::vector<Content>(1));
  for (auto& of_patch : contents)
    for (int i = 1; i < count; ++i)
      of_patch.push_back(
          make_content({static_cast<int>(random.below(kStepsSize)), static_cast<int>(random.below(kStepsSize))},
                       static_cast<int>(random.below(8)), 1.0f));
  return contents;
}

/// The definition, pair of texels by pair of texels and step by step; `has` are the numbers of every patch's contents.
double slow_visibility(const std::vector<std::vector<Content>>& contents, ImageView<const V3f> luv,
                       const Partition& patches, const std::vector<std::vector<size_t>>& has, uint32_t patch,
                       size_t number) {
  const auto step = [](const V3f& a, const V3f& b) { return static_cast<int>((a - b).length() * 16); };
  const auto shown = [&](uint32_t owner, V2i p, const Content& content) {
    const V2i source = shown_source(patches, owner, p, content);
    return luv(source.x, source.y);
  };
  std::vector<int> own;
  std::vector<std::pair<V2i, V2i>> pairs;  // inside and outside of `patch`
  for (int y = 0; y < kStepsSize; ++y)
    for (int x = 0; x < kStepsSize; ++x)
      for (const V2i& direction : {V2i(1, 0), V2i(0, 1)}) {
        const V2i p(x, y), q = wrap(p + direction, patches.size());
        const uint32_t a = patches.idx(p.x, p.y), b = patches.idx(q.x, q.y);
        if (a == b) continue;
        own.push_back(step(luv(p.x, p.y), luv(q.x, q.y)));
        if (a == patch) pairs.emplace_back(p, q);
        if (b == patch) pairs.emplace_back(q, p);
      }
  double sum = 0;
  size_t count = 0;
  for (const auto& [p, q] : pairs) {
    const uint32_t other = patches.idx(q.x, q.y);
    for (const size_t beyond : has[other]) {
      const int seam = step(shown(patch, p, contents[patch][number]), shown(other, q, contents[other][beyond]));
      double below = 0, same = 0;
      for (const int o : own) {
        below += o < seam;
        same += o == seam;
      }
      const auto n = static_cast<double>(own.size());
      sum += (below + same / 2) / n + (below / n >= 0.95 ? 0.5 : 0.0);
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

TEST(BorderSteps, VisibilityIsWhatItsDefinitionSaysWhateverCameAndWent) {
  const Image<V3f> luv = grain(1);
  const Partition patches =
      twin::partition(twin::random_patches(kStepsSize, kStepsSize, kStepsPatches, 2), kStepsPatches);
  const auto contents = random_contents(4, 3);
  BorderSteps steps(contents, luv, patches);
  std::vector<std::vector<size_t>> has(kStepsPatches, {0, 2});
  for (size_t p = 0; p < kStepsPatches; ++p)
    for (const size_t number : {0, 1, 2}) steps.add(p, number);
  for (size_t p = 0; p < kStepsPatches; ++p) steps.remove(p, 1);
  for (uint32_t p = 0; p < kStepsPatches; ++p)
    for (size_t number = 0; number < 4; ++number)
      EXPECT_NEAR(steps.visibility(p, number), slow_visibility(contents, luv, patches, has, p, number), 2e-6);  // 2^-20
}

TEST(BorderSteps, WhatIsNotExchangedIsHalfVisible) {
  // Two patches have one border: ½ by symmetry, and half of the steps beyond the 95th percentile.
  const Image<V3f> luv = grain(4);
  Image<uint32_t> halves(kStepsSize, kStepsSize);
  for (int y = 0; y < kStepsSize; ++y)
    for (int x = kStepsSize / 2; x < kStepsSize; ++x) halves(x, y) = 1;
  const Partition patches = twin::partition(std::move(halves), 2);
  const std::vector<std::vector<Content>> contents(2, std::vector<Content>(1));
  BorderSteps steps(contents, luv, patches);
  for (size_t p = 0; p < 2; ++p) steps.add(p, 0);
  for (size_t p = 0; p < 2; ++p) EXPECT_NEAR(steps.visibility(p, 0), 0.525, 0.011);  // 2 of 96 pairs
}

TEST(BorderSteps, WithoutNeighborsNothingIsVisible) {
  const Image<V3f> luv = grain(6);
  const Partition patches = twin::partition(Image<uint32_t>(kStepsSize, kStepsSize), 1);
  const std::vector<std::vector<Content>> contents(1, std::vector<Content>(2));
  BorderSteps steps(contents, luv, patches);
  steps.add(0, 0);
  EXPECT_EQ(steps.visibility(0, 1), 0.0);
}

}  // namespace
}  // namespace texbake
