#include "libbake/content/select_contents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "libbake/content/take_apart.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

constexpr int kSelectedSize = 128;
constexpr int kSelectedPatches = 9;

// Blobs of four colors on a slow change of light, in nine square patches with wavy borders.
struct SelectionFixture {
  SelectionFixture() : base(kSelectedSize, kSelectedSize) {
    colors.palette.classes.resize(4);
    colors.index = twin::random_classes(kSelectedSize, kSelectedSize, 4, 5);
    colors.variation = Image<float>(kSelectedSize, kSelectedSize);
    const V3f linear[] = {{0.1f, 0.1f, 0.05f}, {0.3f, 0.2f, 0.1f}, {0.2f, 0.4f, 0.2f}, {0.7f, 0.6f, 0.5f}};
    Image<uint32_t> idx(kSelectedSize, kSelectedSize);
    for (int y = 0; y < kSelectedSize; ++y)
      for (int x = 0; x < kSelectedSize; ++x) {
        const auto light = static_cast<float>(1.0 + 0.5 * std::cos(2.0 * M_PI * (x + y) / kSelectedSize));
        base(x, y) = linear[colors.index(x, y)] * light;
        colors.variation(x, y) = 20.0f * (light - 1.0f);
        const auto wave = [](int p) { return static_cast<int>(std::lround(5.0 * std::sin(2.0 * M_PI * p / 32))); };
        const int column = wrap(x + wave(y), kSelectedSize) * 3 / kSelectedSize;
        const int row = wrap(y + wave(x), kSelectedSize) * 3 / kSelectedSize;
        idx(x, y) = static_cast<uint32_t>(3 * row + column);
      }
    patches.partition.idx = std::move(idx);
    for (int i = 0; i < kSelectedPatches; ++i)
      patches.partition.centers.emplace_back((2 * (i % 3) + 1) * kSelectedSize / 6,
                                             (2 * (i / 3) + 1) * kSelectedSize / 6);
  }
  PrincipalVariation colors;
  Image<V3f> base;
  PatchMap patches;
};

ContentSelection select(const SelectionFixture& f, const SelectContentsOptions& options = {}) {
  return select_contents(f.colors, f.base, f.patches, options);
}

TEST(SelectContents, GivesEveryPatchTheIdentityAndOthersFarFromIt) {
  const SelectionFixture f;
  SelectContentsOptions options;
  options.count = 5;
  options.separation_px = 10;
  const ContentTable table = select(f, options).table;
  EXPECT_EQ(table.patch_count, kSelectedPatches);
  EXPECT_EQ(table.content_count, 5);
  ASSERT_EQ(table.contents.size(), 45u);
  for (int patch = 0; patch < kSelectedPatches; ++patch) {
    EXPECT_EQ(table.at(patch, 0), Content{});
    for (int content = 1; content < 5; ++content) {
      const V2i t = table.at(patch, content).translation;
      EXPECT_EQ(t, shortest(t, V2i(kSelectedSize, kSelectedSize)));
      EXPECT_GE(table.at(patch, content).impact, table.at(patch, content - 1).impact);
      for (int other = 0; other < content; ++other)
        EXPECT_TRUE(far_enough(t, table.at(patch, other).translation, {kSelectedSize, kSelectedSize}, 10));
    }
  }
}

TEST(SelectContents, OneContentIsTheIdentityAlone) {
  SelectContentsOptions options;
  options.count = 1;
  const ContentSelection selection = select(SelectionFixture(), options);
  EXPECT_EQ(selection.table.content_count, 1);
  EXPECT_THAT(selection.table.contents, ::testing::Each(Content{}));
  EXPECT_DOUBLE_EQ(selection.figures.repetition_far, 1.0);
}

TEST(SelectContents, BalancedRepeatsLessFromAfarThanLeastImpact) {
  const SelectionFixture f;
  SelectContentsOptions impact;
  impact.choice = Choice::impact;
  const auto least = select(f, impact).figures;
  const auto balanced = select(f).figures;
  EXPECT_LT(balanced.repetition_far, 0.5 * least.repetition_far);
  EXPECT_LT(balanced.use_deviation, least.use_deviation);
  EXPECT_GE(balanced.mean_impact, least.mean_impact);
  EXPECT_LT(balanced.mean_impact, 2.0 * least.mean_impact);
}

TEST(SelectContents, IsTheSameForAnyNumberOfThreads) {
  const SelectionFixture f;
  const ContentSelection all = select(f);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const ContentSelection one = select(f);
  EXPECT_EQ(one.table.contents, all.table.contents);
  EXPECT_EQ(one.figures.mean_pair_impact, all.figures.mean_pair_impact);
  EXPECT_EQ(one.figures.repetition_near, all.figures.repetition_near);
  EXPECT_EQ(one.figures.computed_share, all.figures.computed_share);
}

TEST(SelectContents, ATileWithoutRoomForTheContentsIsRefusedWithNumbers) {
  SelectContentsOptions options;
  options.separation_px = 64;  // on a torus of 128 only three others are that far apart
  options.count = 5;
  try {
    select(SelectionFixture(), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::infeasible);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("expected 4 translations at least 64 px apart"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("the tile has 3"));
  }
  options.count = 4;
  EXPECT_EQ(select(SelectionFixture(), options).table.content_count, 4);
}

TEST(SelectContents, ProgressNeverFallsAndEndsAtOne) {
  const SelectionFixture f;
  double last = 0.0;
  select_contents(f.colors, f.base, f.patches, {}, [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  });
  EXPECT_EQ(last, 1.0);
}

TEST(SelectContents, ResolvesWhatIsNotGivenFromTheTile) {
  const SelectContentsOptions at_512 = resolve({}, 512, 768);
  EXPECT_EQ(at_512.candidates, 120);
  EXPECT_EQ(at_512.separation_px, 32);
  EXPECT_EQ(at_512.search, Search::exact);
  EXPECT_EQ(resolve({}, 2048, 512).search, Search::refined);
  SelectContentsOptions impact;
  impact.choice = Choice::impact;
  EXPECT_EQ(resolve(impact, 512, 512).candidates, impact.count - 1);
  impact.candidates = 3;
  EXPECT_THROW(resolve(impact, 512, 512), Error);
}

TEST(SelectContents, TurnsContentsWhenAsked) {
  const SelectionFixture f;
  SelectContentsOptions options;
  options.rotations = 4;
  options.scales = 2;
  const ContentSelection selection = select(f, options);
  EXPECT_EQ(selection.effective.search, Search::refined);
  int turned = 0;
  for (int patch = 0; patch < kSelectedPatches; ++patch) {
    EXPECT_EQ(selection.table.at(patch, 0), Content{});
    for (const Content& content : selection.table.of(patch)) {
      Content made = make_content(content.translation, content.rotation_eighths, content.scale);
      made.impact = content.impact;
      EXPECT_EQ(content, made);
      turned += content.rotation_eighths != 0;
      EXPECT_EQ(content.rotation_eighths % 2, 0);
    }
  }
  EXPECT_GT(turned, 0);
}

TEST(SelectContents, DeformsByDefaultOnlyWhereTheCallerSaysSo) {
  EXPECT_EQ(resolve({}, 512, 512).rotations, 1);
  EXPECT_EQ(resolve({}, 512, 512).scales, 1);
  const SelectContentsOptions deformed = resolve(deforming({}), 512, 512);
  EXPECT_EQ(deformed.rotations, 2);  // half a turn keeps directions
  EXPECT_EQ(deformed.scales, 1);     // plates and leaves keep their size
  EXPECT_EQ(deformed.search, Search::refined);
  SelectContentsOptions asked;
  asked.rotations = 1;
  EXPECT_EQ(deforming(asked).rotations, 1);
}

TEST(SelectContents, RefusesRotationsThatDoNotDivideATurnAndExactTurns) {
  SelectContentsOptions options;
  options.rotations = 3;
  EXPECT_THROW(resolve(options, 512, 512), Error);
  options.rotations = 2;
  options.search = Search::exact;
  EXPECT_THROW(resolve(options, 512, 512), Error);
}

}  // namespace
}  // namespace texbake
