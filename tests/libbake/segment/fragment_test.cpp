#include "libbake/segment/fragment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "libbake/base/error.h"
#include "tests/libbake/segment/ascii.h"
#include "tests/libbake/segment/oracle.h"
#include "tests/libbake/segment/random_tile.h"
#include "tests/libbake/segment/slow_fragment.h"

namespace texbake {
namespace {

FragmentMap fragment_of(const PrincipalVariation& tile, const FragmentOptions& options = {}) {
  return fragment(tile, decode(tile), options);
}

/// Discs of class 1 on a ground of class 0, one across the corner.
PrincipalVariation discs(int size) {
  auto tile = random_tile(size, size, 2, 1);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int pitch = size / 4;
      const V2i d(shortest(x, pitch), shortest(y, pitch));
      const bool is_disc = 25 * (d.x * d.x + d.y * d.y) < 4 * pitch * pitch;  // radius 0.4 of the pitch
      tile.index(x, y) = is_disc ? 1 : 0;
      tile.variation(x, y) = 0;
    }
  return tile;
}

TEST(Fragment, EveryTexelHasExactlyOneConnectedFragment) {
  for (uint32_t seed = 1; seed <= 8; ++seed) {
    const auto tile = random_tile(64, 48, 4, seed);
    const auto map = fragment_of(tile, {.min_area_px = 12, .max_area_px = 120, .seed = seed});
    expect_whole(map.partition);
    EXPECT_TRUE(check_partition(map.partition).empty());
    EXPECT_EQ(map.fragments.size(), map.partition.centers.size());
  }
}

TEST(Fragment, IdxAreNumberedByTheirFirstTexelInRowOrder) {
  const auto map = fragment_of(random_tile(64, 48, 4, 3));
  uint32_t next = 0;
  for (const uint32_t f : map.partition.idx) {
    ASSERT_LE(f, next);
    if (f == next) ++next;
  }
}

TEST(Fragment, NoFragmentIsBelowTheMinimumWhereANeighborCouldTakeIt) {
  const auto tile = random_tile(96, 64, 4, 2);
  const auto map = fragment_of(tile, {.min_area_px = 20, .max_area_px = 200});
  for (const uint32_t area : map.partition.areas_px) EXPECT_GE(area, 20u);
}

TEST(Fragment, NoneIsWiderOrHigherThanAQuarterOfTheTile) {
  const auto map = fragment_of(random_tile(80, 40, 1, 2), {.threshold = 100.0f, .max_area_px = 10000});
  for (uint32_t f = 0; f < static_cast<uint32_t>(map.partition.count()); ++f) {
    const auto texels = slow::texels_of(map.partition.idx, f);
    EXPECT_TRUE(slow::fits(map.partition.idx, f, texels[0], V2i(19, 9)));
  }
}

TEST(Fragment, AFeatureIsOneFragmentWithItsClassAndItsMeanColor) {
  const auto tile = discs(64);
  const Image<V3f> base = decode(tile);
  // A minimum of 1: what the maximum leaves of the ground between the discs must not be given to a disc.
  const auto map = fragment(tile, base, {.min_area_px = 1, .max_area_px = 400, .denoise_px = 0.0f});
  // Discs have their centers at multiples of 16, the one at (0, 0) across the corner.
  for (int y = 0; y < 64; y += 16)
    for (int x = 0; x < 64; x += 16) {
      const uint32_t disc = map.partition.idx(x, y);
      EXPECT_EQ(map.partition.centers[disc], V2i(x, y));
      EXPECT_EQ(map.partition.areas_px[disc], 129u);  // texels with x² + y² < 6.4²
      EXPECT_EQ(map.fragments[disc].class_idx, 1u);
      for (int c = 0; c < 3; ++c)  // 2^-11: half a half-float step relative to the value
        EXPECT_NEAR(map.fragments[disc].mean_color[c], base(x, y)[c], std::fabs(base(x, y)[c]) * 0x1p-11f);
    }
}

TEST(Fragment, DenoisingBringsFeaturesOutOfHeavyGrain) {
  // Discs 8 ΔE lighter than their ground, of the same class, under grain of up to 8 ΔE either way: no threshold holds a
  // disc together and the ground apart.
  const auto ideal = discs(128);
  PrincipalVariation tile{{{ideal.palette.classes[0]}}, Image<uint8_t>(128, 128), Image<float>(128, 128)};
  Random random(4);
  for (size_t at = 0; at < tile.variation.size(); ++at)
    tile.variation.data()[at] = 8 * static_cast<float>(ideal.index.data()[at]) + 16 * random.uniform() - 8;
  const auto mean_overlap = [&](float denoise_px) {
    const auto map =
        fragment_of(tile, {.threshold = 4.0f, .min_area_px = 100, .max_area_px = 800, .denoise_px = denoise_px});
    // The best of all fragments for the disc around (x, y): common texels / texels of either.
    double sum = 0;
    for (int y = 0; y < 128; y += 32)
      for (int x = 0; x < 128; x += 32) {
        std::vector<int> common(map.fragments.size(), 0);
        int disc_area = 0;
        for (int dy = -14; dy <= 14; ++dy)
          for (int dx = -14; dx <= 14; ++dx) {
            const V2i p = wrap(V2i(x + dx, y + dy), V2i(128, 128));
            if (ideal.index(p.x, p.y) == 0) continue;
            ++disc_area;
            ++common[map.partition.idx(p.x, p.y)];
          }
        double best = 0;
        for (size_t f = 0; f < common.size(); ++f)
          best =
              std::max(best, common[f] / double(disc_area + static_cast<int>(map.partition.areas_px[f]) - common[f]));
        sum += best;
      }
    return sum / 16;
  };
  EXPECT_GT(mean_overlap(1.5f), 0.8);
  EXPECT_LT(mean_overlap(0.0f), 0.6);
}

TEST(Fragment, MovingTheTorusKeepsTheLaws) {
  const auto tile = random_tile(40, 40, 3, 7);
  for (const V2i& by : {V2i(1, 0), V2i(20, 20), V2i(39, 13)}) {
    PrincipalVariation moved{tile.palette, Image<uint8_t>(40, 40), Image<float>(40, 40)};
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        moved.index(wrap(x + by.x, 40), wrap(y + by.y, 40)) = tile.index(x, y);
        moved.variation(wrap(x + by.x, 40), wrap(y + by.y, 40)) = tile.variation(x, y);
      }
    expect_whole(fragment_of(moved).partition);
  }
}

TEST(Fragment, ThreadsDoNotChangeTheResult) {
  const auto tile = random_tile(128, 96, 4, 11);
  const FragmentOptions options{.denoise_px = 1.0f};
  const auto many = fragment_of(tile, options);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = fragment_of(tile, options);
  EXPECT_EQ(many.partition.idx, one.partition.idx);
  EXPECT_EQ(many.partition.owner, one.partition.owner);
  for (size_t f = 0; f < many.fragments.size(); ++f)
    EXPECT_EQ(many.fragments[f].mean_color, one.fragments[f].mean_color);
}

TEST(Fragment, SeedsChangeTheMap) {
  const auto tile = random_tile(64, 64, 3, 1);
  EXPECT_NE(fragment_of(tile, {.seed = 1}).partition.idx, fragment_of(tile, {.seed = 2}).partition.idx);
}

TEST(Fragment, ResolvedOptionsGiveTheSameMapAsAutomaticOnes) {
  const auto tile = random_tile(300, 280, 3, 1);
  const auto resolved = resolve(FragmentOptions{}, tile);
  EXPECT_TRUE(resolved.threshold && resolved.min_area_px && resolved.max_area_px && resolved.denoise_px);
  EXPECT_GT(*resolved.denoise_px, 0);
  EXPECT_EQ(fragment_of(tile).partition.idx, fragment_of(tile, resolved).partition.idx);
}

TEST(Fragment, AConstantPictureIsCutByTheGreatestAreaAlone) {
  PrincipalVariation flat{random_tile(64, 64, 1, 1).palette, Image<uint8_t>(64, 64), Image<float>(64, 64)};
  const auto map = fragment_of(flat);
  expect_whole(map.partition);
  EXPECT_GE(map.partition.count(), 64 * 64 / (2 * 26)) << "26 is 4096 / 160, and cleaning may exceed it";
}

TEST(Fragment, SmallAndNarrowTilesAreWhole) {
  for (const V2i& size : {V2i(32, 32), V2i(64, 16), V2i(16, 64), V2i(5, 7), V2i(3, 3), V2i(200, 4)}) {
    const auto map = fragment_of(random_tile(size.x, size.y, 2, 1));
    expect_whole(map.partition);
  }
}

TEST(Fragment, ATileUnderThreeTexelsIsInfeasible) {
  for (const V2i& size : {V2i(1, 1), V2i(2, 64), V2i(64, 2)}) {
    const auto tile = random_tile(size.x, size.y, 2, 1);
    EXPECT_THROW(
        try { fragment_of(tile); } catch (const Error& error) {
          EXPECT_EQ(error.kind(), ErrorKind::infeasible);
          throw;
        },
        Error);
  }
}

TEST(Fragment, AMinimumAboveTheMaximumIsAUsageError) {
  const auto tile = random_tile(32, 32, 2, 1);
  EXPECT_THROW(resolve(FragmentOptions{.min_area_px = 50, .max_area_px = 40}, tile), Error);
  EXPECT_EQ(*resolve(FragmentOptions{.max_area_px = 4}, random_tile(200, 200, 2, 1)).min_area_px, 4)
      << "an automatic minimum gives way";
  EXPECT_EQ(*resolve(FragmentOptions{.min_area_px = 500}, tile).max_area_px, 500) << "so does an automatic maximum";
}

}  // namespace
}  // namespace texbake
