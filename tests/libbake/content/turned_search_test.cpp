#include "libbake/content/turned_search.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "libbake/content/take_apart.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

constexpr int kTurnedSize = 72;

// Square patches, `across` by `across`.
struct TurnedTile {
  explicit TurnedTile(uint64_t seed, int size = kTurnedSize, int across = 3)
      : classes(twin::random_classes(size, size, 5, seed)), distances(class_distances(twin::random_colors(5, seed))) {
    Image<uint32_t> idx(size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) idx(x, y) = static_cast<uint32_t>(y * across / size * across + x * across / size);
    patches = twin::partition(std::move(idx), across * across);
    for (int i = 0; i < across * across; ++i)
      patches.centers[static_cast<size_t>(i)] = {(2 * (i % across) + 1) * size / (2 * across),
                                                 (2 * (i / across) + 1) * size / (2 * across)};
  }
  SearchResult search(const Turns& turns, const SearchRequest& request) const {
    return search_contents_turned(classes, distances, patches, turns, request);
  }
  uint64_t obvious_error_sum(uint32_t patch, const Content& turn, V2i t) const {
    Content content = turn;
    content.translation = t;
    const V2i center = patches.centers[patch];
    const auto source_of = [&](V2i p) { return center + source_offset(content, shortest(p - center, patches.size())); };
    return twin::error_sum_of(classes, distances, twin::dilated_border(patches.idx, patch), source_of);
  }

  Image<uint8_t> classes;
  ClassDistances distances;
  Partition patches;
};

TEST(TurnedSearch, TurnsAreAllRotationsOfAllScalesTheIdentityFirst) {
  EXPECT_EQ(make_turns(1, 1, 0.5f), Turns{Content{}});
  const Turns turns = make_turns(4, 3, 0.5f);
  ASSERT_EQ(turns.size(), 12u);
  for (int i = 0; i < 12; ++i)
    EXPECT_EQ(turns[static_cast<size_t>(i)], make_content({0, 0}, i % 4 * 2, 1.0f - 0.25f * static_cast<float>(i / 4)));
  EXPECT_EQ(make_turns(1, 3, 0.99f).size(), 2u);  // 1, 63.68/64 and 63.36/64: the second is 64/64 again
}

TEST(TurnedSearch, GivesExactErrorsFarApartInOrder) {
  const TurnedTile tile(1);
  const Turns turns = make_turns(8, 2, 0.5f);
  const SearchResult found = tile.search(turns, {12, 9});
  for (uint32_t patch = 0; patch < 9; ++patch) {
    const Candidates& candidates = found.candidates[patch];
    ASSERT_EQ(candidates.size(), 12u);
    for (size_t a = 0; a < candidates.size(); ++a) {
      const Candidate& candidate = candidates[a];
      EXPECT_EQ(candidate.error_sum,
                tile.obvious_error_sum(patch, turns[static_cast<size_t>(candidate.turn)], candidate.translation));
      EXPECT_GE(candidate.error_sum, candidates[a > 0 ? a - 1 : 0].error_sum);
      EXPECT_TRUE(far_enough(candidate.translation, {0, 0}, {kTurnedSize, kTurnedSize}, 9));
      for (size_t b = 0; b < a; ++b)
        EXPECT_TRUE(far_enough(candidate.translation, candidates[b].translation, {kTurnedSize, kTurnedSize}, 9));
    }
  }
}

TEST(TurnedSearch, WithoutTurnsFindsNearlyWhatTheExactSearchFinds) {
  const TurnedTile tile(2);
  const SearchRequest request{10, 7};
  const SearchResult refined = tile.search(make_turns(1, 1, 0.5f), request);
  const SearchResult exact = search_contents(tile.classes, tile.distances, patch_borders(tile.patches.idx, 9), request);
  for (size_t patch = 0; patch < 9; ++patch) {
    uint64_t refined_sum = 0, exact_sum = 0;
    for (size_t i = 0; i < 10; ++i) {
      EXPECT_GE(refined.candidates[patch][i].error_sum, exact.candidates[patch][0].error_sum);
      refined_sum += refined.candidates[patch][i].error_sum;
      exact_sum += exact.candidates[patch][i].error_sum;
    }
    EXPECT_LT(static_cast<double>(refined_sum), 1.03 * static_cast<double>(exact_sum));  // the task is to be near
  }
  EXPECT_LT(refined.error_count, exact.all_error_count);
}

// Puts what the border of the middle patch sees elsewhere, so that `content` shows it there again.
void plant(TurnedTile& tile, const Content& content) {
  const V2i center = tile.patches.centers[4];
  const Image<uint8_t> before = tile.classes.clone();
  for (int y = -17; y <= 17; ++y)
    for (int x = -17; x <= 17; ++x) {
      const V2i p = wrap(center + V2i(x, y), tile.patches.size());
      const V2i source = wrap(center + source_offset(content, {x, y}), tile.patches.size());
      tile.classes(source.x, source.y) = before(p.x, p.y);
    }
}

TEST(TurnedSearch, FindsAPlantedCopyThatIsTurned) {
  for (const int eighths : {2, 4, 6}) {
    TurnedTile tile(3);
    const Content planted = make_content({36, 35}, eighths, 1.0f);
    plant(tile, planted);
    const Turns turns = make_turns(8, 2, 0.5f);
    const Candidate best = tile.search(turns, {5, 8}).candidates[4][0];
    EXPECT_EQ(best.error_sum, 0u);
    EXPECT_EQ(shortest(best.translation, {kTurnedSize, kTurnedSize}),
              shortest(V2i(36, 35), {kTurnedSize, kTurnedSize}));
    EXPECT_EQ(turns[static_cast<size_t>(best.turn)].rotation_eighths, eighths);
  }
}

TEST(TurnedSearch, FindsAPlantedCopyThatIsLarger) {
  // On a tile whose cells are larger than texels, a turned copy at twice the size, of all that the border of a patch of
  // 60 × 60 texels sees: within 35 texels of its center, of 70 around that of the copy.
  TurnedTile tile(4, 300, 5);
  const V2i center = tile.patches.centers[12], size(300, 300);
  const Content planted = make_content({-148, 147}, 2, 0.5f);
  Image<uint8_t> classes = tile.classes.clone();
  for (int y = -36; y <= 36; ++y)
    for (int x = -36; x <= 36; ++x) {
      const V2i p = wrap(center + V2i(x, y), size);
      for (int corner = 0; corner < 4; ++corner) {
        const V2i source = wrap(center + source_offset(planted, {x, y}) + V2i(corner % 2, corner / 2), size);
        classes(source.x, source.y) = tile.classes(p.x, p.y);
      }
    }
  tile.classes = std::move(classes);
  const Turns turns = make_turns(4, 2, 0.5f);
  const Candidate best = tile.search(turns, {5, 18}).candidates[12][0];
  EXPECT_EQ(best.error_sum, 0u);
  EXPECT_EQ(turns[static_cast<size_t>(best.turn)], make_content({0, 0}, 2, 0.5f));
}

TEST(TurnedSearch, IsTheSameForAnyNumberOfThreads) {
  const TurnedTile tile(5);
  const Turns turns = make_turns(4, 2, 0.5f);
  const SearchResult all = tile.search(turns, {8, 6});
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const SearchResult one = tile.search(turns, {8, 6});
  EXPECT_EQ(one.candidates, all.candidates);
  EXPECT_EQ(one.error_count, all.error_count);
}

}  // namespace
}  // namespace texbake
