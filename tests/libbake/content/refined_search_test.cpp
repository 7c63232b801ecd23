#include "libbake/content/refined_search.h"

#include <gtest/gtest.h>

#include "libbake/content/take_apart.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

TEST(RefinedSearch, IsTheExactOneUpTo1024) {
  const auto classes = twin::random_classes(64, 48, 4, 1);
  const auto distances = class_distances(twin::random_colors(4, 1));
  const auto patches = twin::random_patches(64, 48, 4, 1);
  const SearchRequest request{6, 5};
  EXPECT_EQ(search_contents_refined(classes, distances, patches, 4, request).candidates,
            search_contents(classes, distances, patch_borders(patches, 4), request).candidates);
}

// A tile longer than 1024 texels, of blobs 6 texels wide so that its half still shows them.
struct LongTile {
  LongTile() : classes(kWidth, kHeight) {
    const auto coarse = twin::random_classes(kWidth / 6 + 1, kHeight / 6 + 1, 4, 3);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) classes(x, y) = coarse(x / 6, y / 6);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) patches(x, y) = static_cast<uint32_t>(x / 173 % 2);
  }
  static constexpr int kWidth = 1038;
  static constexpr int kHeight = 48;
  Image<uint8_t> classes;
  ClassDistances distances = class_distances(twin::random_colors(4, 3));
  Image<uint32_t> patches = Image<uint32_t>(kWidth, kHeight);
  SearchRequest request{8, 12};
};

TEST(RefinedSearch, GivesExactErrorsFarApart) {
  const LongTile tile;
  const SearchResult found = search_contents_refined(tile.classes, tile.distances, tile.patches, 2, tile.request);
  const V2i size(LongTile::kWidth, LongTile::kHeight);
  for (uint32_t patch = 0; patch < 2; ++patch) {
    const auto border = twin::dilated_border(tile.patches, patch);
    const Candidates& candidates = found.candidates[patch];
    ASSERT_EQ(candidates.size(), 8u);
    for (size_t a = 0; a < candidates.size(); ++a) {
      EXPECT_EQ(candidates[a].error_sum,
                twin::error_sum(tile.classes, tile.distances, border, candidates[a].translation));
      for (size_t b = 0; b < a; ++b)
        EXPECT_TRUE(far_enough(candidates[a].translation, candidates[b].translation, size, 12));
    }
  }
}

TEST(RefinedSearch, FindsAsManyAsAskedForThoughTheBestStandTogether) {
  LongTile tile;
  tile.request.count = 100;
  const SearchResult found = search_contents_refined(tile.classes, tile.distances, tile.patches, 2, tile.request);
  for (const Candidates& candidates : found.candidates) EXPECT_EQ(candidates.size(), 100u);
}

TEST(RefinedSearch, FindsWhatTheExactSearchFindsBest) {
  const LongTile tile;
  const SearchResult refined = search_contents_refined(tile.classes, tile.distances, tile.patches, 2, tile.request);
  const SearchResult exact =
      search_contents(tile.classes, tile.distances, patch_borders(tile.patches, 2), tile.request);
  for (size_t patch = 0; patch < 2; ++patch)
    EXPECT_EQ(refined.candidates[patch].front(), exact.candidates[patch].front());
  EXPECT_EQ(refined.all_error_count, exact.all_error_count);
}

}  // namespace
}  // namespace texbake
