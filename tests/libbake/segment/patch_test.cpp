#include "libbake/segment/patch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>

#include "libbake/base/error.h"
#include "tests/libbake/segment/ascii.h"
#include "tests/libbake/segment/oracle.h"
#include "tests/libbake/segment/random_tile.h"

namespace texbake {
namespace {

struct Given {
  Image<V3f> base;
  FragmentMap fragments;
};

Given fragments_of(V2i size, uint32_t seed = 1) {
  const auto tile = random_tile(size.x, size.y, 4, seed);
  Given given{decode(tile), {}};
  given.fragments = fragment(tile, given.base);
  return given;
}

void expect_unions_of_fragments(const PatchMap& patches, const FragmentMap& fragments) {
  std::map<uint32_t, uint32_t> patch_of;
  for (size_t at = 0; at < patches.partition.idx.size(); ++at) {
    const uint32_t patch = patches.partition.idx.data()[at];
    const auto [found, is_new] = patch_of.try_emplace(fragments.partition.idx.data()[at], patch);
    ASSERT_EQ(found->second, patch);
  }
}

TEST(Patch, IsAPartitionIntoConnectedUnionsOfWholeFragments) {
  const auto [base, fragments] = fragments_of(V2i(192, 160));
  for (uint32_t seed = 1; seed <= 10; ++seed) {
    const auto patches = patch(fragments, base, {.count = {}, .seed = seed});
    EXPECT_EQ(patches.partition.count(), 16);
    expect_whole(patches.partition);
    expect_unions_of_fragments(patches, fragments);
  }
}

TEST(Patch, AreasAreSimilar) {
  for (uint32_t seed = 1; seed <= 10; ++seed) {
    const auto [base, fragments] = fragments_of(V2i(192, 192), seed);
    const auto quality = patch_quality(patch(fragments, base, {.count = {}, .seed = seed}), fragments, base);
    EXPECT_LE(quality.area_variation, 0.25) << "seed " << seed;
  }
}

TEST(Patch, OneLiesAcrossTheCornerAndSomeAcrossEachBorder) {
  for (uint32_t seed = 1; seed <= 10; ++seed) {
    const auto [base, fragments] = fragments_of(V2i(160, 160), seed);
    const auto quality = patch_quality(patch(fragments, base, {.count = {}, .seed = seed}), fragments, base);
    EXPECT_TRUE(quality.is_across_corner);
    EXPECT_GE(quality.across_border, 3);
  }
}

TEST(Patch, LongAndSmallTilesAreWholeToo) {
  for (const V2i& size : {V2i(256, 128), V2i(128, 256), V2i(256, 64), V2i(64, 256), V2i(256, 32), V2i(32, 32)})
    for (uint32_t seed = 1; seed <= 4; ++seed) {
      const auto [base, fragments] = fragments_of(size, seed);
      const auto patches = patch(fragments, base, {.count = {}, .seed = seed});
      expect_whole(patches.partition);
      expect_unions_of_fragments(patches, fragments);
    }
}

TEST(Patch, AnyCountFromNineUpIsReached) {
  const auto [base, fragments] = fragments_of(V2i(160, 128), 3);
  for (const int count : {9, 10, 13, 20, 40, 100}) {
    const auto patches = patch(fragments, base, {.count = count});
    EXPECT_EQ(patches.partition.count(), count);
    expect_whole(patches.partition);
  }
}

TEST(Patch, AsManyPatchesAsFragmentsAreTheFragments) {
  const auto [base, fragments] = fragments_of(V2i(48, 48), 2);
  const auto patches = patch(fragments, base, {.count = fragments.partition.count()});
  EXPECT_EQ(patches.partition.idx, fragments.partition.idx);
}

TEST(Patch, FewFragmentsGiveFewPatches) {
  // 25 squares of 4×4 texels: nine patches, of two or three squares each.
  Image<uint32_t> idx(20, 20);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) idx(x, y) = static_cast<uint32_t>(y / 4 * 5 + x / 4);
  FragmentMap fragments{unwrap(std::move(idx)), std::vector<Fragment>(25)};
  EXPECT_EQ(*resolve(PatchOptions{}, fragments).count, 9);
  const Image<V3f> base(20, 20);
  const auto patches = patch(fragments, base);
  EXPECT_EQ(patches.partition.count(), 9);
  expect_whole(patches.partition);
}

TEST(Patch, BordersFollowTheContrastOfFragments) {
  double ratio = 0;
  for (uint32_t seed = 1; seed <= 5; ++seed) {
    const auto [base, fragments] = fragments_of(V2i(192, 192), seed);
    const auto quality = patch_quality(patch(fragments, base, {.count = {}, .seed = seed}), fragments, base);
    ratio += quality.border_delta_e / quality.fragment_delta_e / 5;
  }
  EXPECT_GT(ratio, 1.1);  // 1: borders of fragments chosen by chance
}

TEST(Patch, IsTheSameEachTimeAndForAnyThreads) {
  const auto [base, fragments] = fragments_of(V2i(128, 128));
  const auto many = patch(fragments, base);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = patch(fragments, base);
  EXPECT_EQ(many.partition.idx, one.partition.idx);
  EXPECT_EQ(many.partition.owner, one.partition.owner);
  EXPECT_EQ(many.partition.centers, one.partition.centers);
}

TEST(Patch, SeedsChangeTheMap) {
  const auto [base, fragments] = fragments_of(V2i(128, 128));
  EXPECT_NE(patch(fragments, base, {.count = {}, .seed = 1}).partition.idx,
            patch(fragments, base, {.count = {}, .seed = 2}).partition.idx);
}

std::string infeasible(const Given& given, int count) {
  try {
    patch(given.fragments, given.base, {.count = count});
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::infeasible);
    return error.what();
  }
  return "";
}

TEST(Patch, MorePatchesThanFragmentsAreInfeasible) {
  const auto given = fragments_of(V2i(48, 48), 2);
  const int available = given.fragments.partition.count();
  EXPECT_THAT(infeasible(given, available + 1), testing::HasSubstr("found " + std::to_string(available)));
}

TEST(Patch, FewerThanFiveAreInfeasibleOnAnyTile) {
  EXPECT_THAT(infeasible(fragments_of(V2i(64, 64)), 4), testing::HasSubstr("at least 5"));
}

TEST(Patch, WhereSoFewCannotBeUnderHalfTheTileThereAreMore) {
  // Five patches of a fifth of the tile each are just possible in the plane, hardly with whole fragments.
  const auto [base, fragments] = fragments_of(V2i(128, 128));
  const auto patches = patch(fragments, base, {.count = 5});
  EXPECT_GE(patches.partition.count(), 5);
  EXPECT_LE(patches.partition.count(), 16);
  expect_whole(patches.partition);
}

TEST(PatchQuality, SaysWhatIsDrawn) {
  // Four patches of two squares each and eight of one; 0 lies across the left border, b and 8 across none.
  const auto patches =
      PatchMap{unwrap(ascii_ids("011223300 "
                                "011223300 "
                                "445566774 "
                                "445566774 "
                                "8899aabb8 "
                                "8899aabb8 "
                                "8899aabb8 "
                                "ccddeeffc "
                                "ccddeeffc"))};
  FragmentMap fragments{unwrap(patches.partition.idx.clone()), std::vector<Fragment>(16)};
  const auto quality = patch_quality(patches, fragments, Image<V3f>(9, 9));
  EXPECT_EQ(quality.min_area_px, 4u);
  EXPECT_EQ(quality.max_area_px, 9u);
  EXPECT_EQ(quality.across_border, 4) << "0, 4, 8 and c";
  EXPECT_FALSE(quality.is_across_corner) << "the lower corners belong to c";
  EXPECT_EQ(quality.border_delta_e, 0) << "the picture is black";
}

}  // namespace
}  // namespace texbake
