#include "libbake/content/content_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <tbb/global_control.h>

#include "libbake/content/take_apart.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

using ::testing::ElementsAreArray;

struct SearchTile {
  Image<uint8_t> classes;
  ClassDistances distances;
  Image<uint32_t> patches;
  int patch_count;
};

SearchTile random_tile(int width, int height, int class_count, int patch_count, uint64_t seed) {
  return {twin::random_classes(width, height, class_count, seed),
          class_distances(twin::random_colors(class_count, seed)),
          twin::random_patches(width, height, patch_count, seed), patch_count};
}

SearchResult search(const SearchTile& tile, const SearchRequest& request) {
  return search_contents(tile.classes, tile.distances, patch_borders(tile.patches, tile.patch_count), request);
}

void expect_equal_to_the_twin(const SearchTile& tile, const SearchRequest& request) {
  const SearchResult found = search(tile, request);
  for (int patch = 0; patch < tile.patch_count; ++patch) {
    const auto border = twin::dilated_border(tile.patches, static_cast<uint32_t>(patch));
    EXPECT_THAT(found.candidates[static_cast<size_t>(patch)],
                ElementsAreArray(twin::search(tile.classes, tile.distances, border, request)))
        << "patch " << patch;
  }
}

struct Shape {
  int width, height, class_count, patch_count, count, separation_px;
};

class SearchOfRandomTiles : public ::testing::TestWithParam<Shape> {};

TEST_P(SearchOfRandomTiles, EqualsTheObviousLoop) {
  const Shape s = GetParam();
  for (uint64_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE(seed);
    expect_equal_to_the_twin(random_tile(s.width, s.height, s.class_count, s.patch_count, seed),
                             {s.count, s.separation_px});
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, SearchOfRandomTiles,
                         ::testing::Values(Shape{32, 32, 5, 3, 6, 5}, Shape{70, 17, 8, 3, 4, 4},     // not square, odd
                                           Shape{17, 40, 3, 3, 8, 3}, Shape{28, 28, 16, 4, 5, 3},    // a whole shuffle
                                           Shape{24, 24, 17, 3, 5, 4}, Shape{20, 20, 100, 2, 4, 3},  // several planes
                                           Shape{5, 4, 2, 2, 3, 1}, Shape{1, 9, 2, 2, 2, 1},  // smaller than the mask
                                           Shape{24, 24, 1, 3, 5, 8},                         // no contrast: all ties
                                           Shape{24, 24, 2, 3, 100, 9}));  // more than there is room for

// The error sum of a translation, from the list of all of them.
uint64_t error_sum(const Candidates& candidates, V2i t) {
  const auto found = std::ranges::find(candidates, t, &Candidate::translation);
  return found == candidates.end() ? UINT64_MAX : found->error_sum;
}

TEST(ContentSearch, KeepsToTheAllowedTranslations) {
  const SearchTile tile = random_tile(70, 40, 5, 3, 4);
  Image<uint8_t> allowed(70, 40);
  for (int y = 0; y < 40; y += 5)
    for (int x = 0; x < 70; x += 7) allowed(x, y) = 1;
  const SearchResult all = search(tile, {70 * 40, 1});
  const SearchResult found = search(tile, {12, 6, allowed});
  for (size_t patch = 0; patch < 3; ++patch) {
    Candidates expected = all.candidates[patch];
    std::erase_if(expected, [&](const Candidate& c) { return !allowed(c.translation.x, c.translation.y); });
    EXPECT_THAT(found.candidates[patch], ElementsAreArray(take_separated(expected, {70, 40}, {12, 6})));
  }
}

TEST(ContentSearch, SumsTheErrorsOfEquation3) {
  // One texel of class 1, at column 8 of row 8, in a tile of class 0; patches are the left and the right half. The
  // dilated border of patch 0 is columns 14, 15, 0, 1, 2 and 5 … 9, that of patch 1 is 6 … 10 and 13, 14, 15, 0, 1.
  Image<uint8_t> classes(16, 16);
  classes(8, 8) = 1;
  Image<uint32_t> patches(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 8; x < 16; ++x) patches(x, y) = 1;
  const V3f colors[] = {{0, 0, 0}, {10, 0, 0}};
  const SearchResult all = search({std::move(classes), class_distances(colors), std::move(patches), 2}, {255, 1});
  constexpr uint64_t kSquare = 255 * 255;  // δ² where δ is not 0

  // By 3 columns δ is not 0 at (8, 8) and (5, 8), which see each other: E = 2 δ² at both. (5, 8) is no texel of
  // patch 1's border.
  EXPECT_EQ(error_sum(all.candidates[0], {3, 0}), 4 * kSquare);
  EXPECT_EQ(error_sum(all.candidates[1], {3, 0}), 2 * kSquare);
  // By 4 columns (4, 8) is out of sight of (8, 8), and in no border: E = δ².
  EXPECT_EQ(error_sum(all.candidates[0], {4, 0}), kSquare);
  // By 3 and by 4 rows both texels lie in the border.
  EXPECT_EQ(error_sum(all.candidates[0], {0, 3}), 4 * kSquare);
  EXPECT_EQ(error_sum(all.candidates[0], {0, 4}), 2 * kSquare);
}

TEST(ContentSearch, IsTheSameForAnyNumberOfThreads) {
  const SearchTile tile = random_tile(64, 50, 6, 4, 9);
  const SearchRequest request{8, 6};
  const SearchResult all = search(tile, request);
  for (const size_t threads : {1u, 2u, 3u, 8u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const SearchResult some = search(tile, request);
    EXPECT_EQ(some.candidates, all.candidates) << threads;
    EXPECT_EQ(some.error_count, all.error_count) << threads;
  }
}

TEST(ContentSearch, IsTheSameForAnyInstructionSet) {
  const SearchTile tile = random_tile(40, 22, 20, 3, 10);
  const SearchRequest request{8, 6};
  const SearchResult best = search(tile, request);
  for (int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets & -targets);
    const SearchResult one = search(tile, request);
    EXPECT_EQ(one.candidates, best.candidates) << hwy::TargetName(targets & -targets);
    EXPECT_EQ(one.error_count, best.error_count) << hwy::TargetName(targets & -targets);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(ContentSearch, FindsAPlantedCopyWithoutImpact) {
  // Patch 0 is a square in noise; the same texels, with what the border sees around them, stand at (37, 29).
  constexpr int kSearchSize = 96;
  Image<uint8_t> classes = twin::random_classes(kSearchSize, kSearchSize, 6, 4);
  Image<uint32_t> patches(kSearchSize, kSearchSize, 1);
  for (int y = 20; y < 36; ++y)
    for (int x = 88; x < 104; ++x) patches(wrap(x, kSearchSize), y) = 0;  // across the border of the tile
  for (int y = 20 - 6; y < 36 + 6; ++y)
    for (int x = 88 - 6; x < 104 + 6; ++x)
      classes(wrap(x + 37, kSearchSize), wrap(y + 29, kSearchSize)) = classes(wrap(x, kSearchSize), y);

  const SearchTile tile{classes.clone(), class_distances(twin::random_colors(6, 4)), patches.clone(), 2};
  const Candidate best = search(tile, {5, 8}).candidates[0][0];
  EXPECT_EQ(best.translation, V2i(37, 29));
  EXPECT_EQ(best.error_sum, 0u);
}

TEST(ContentSearch, KeepsCandidatesApartOnTheTorus) {
  const SearchTile tile = random_tile(96, 64, 4, 4, 5);
  const SearchRequest request{20, 9};
  for (const Candidates& candidates : search(tile, request).candidates) {
    EXPECT_EQ(candidates.size(), 20u);
    for (size_t a = 0; a < candidates.size(); ++a) {
      EXPECT_TRUE(far_enough(candidates[a].translation, {0, 0}, {96, 64}, 9));
      for (size_t b = 0; b < a; ++b)
        EXPECT_TRUE(far_enough(candidates[a].translation, candidates[b].translation, {96, 64}, 9));
    }
  }
  EXPECT_FALSE(far_enough({95, 0}, {7, 63}, {96, 64}, 9));  // 8 and 1 steps across the border
  EXPECT_TRUE(far_enough({95, 0}, {8, 63}, {96, 64}, 9));
}

TEST(ContentSearch, ComputesFewErrorsWhereManyTranslationsArePerfect) {
  // Repeats every 16 texels: once three of the 63 perfect translations are found, the first error ends a sum.
  Image<uint8_t> classes = twin::random_classes(128, 128, 6, 8);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) classes(x, y) = classes(x % 16, y % 16);
  const SearchTile tile{std::move(classes), class_distances(twin::random_colors(6, 8)),
                        twin::random_patches(128, 128, 6, 8), 6};
  const SearchResult found = search(tile, {3, 8});
  for (const Candidates& candidates : found.candidates) EXPECT_EQ(candidates[2].error_sum, 0u);
  EXPECT_LT(found.error_count, found.all_error_count / 2);
}

}  // namespace
}  // namespace texbake
