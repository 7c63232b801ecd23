// Tests shaders/hash.glsl and the draw of a content.
#include <gtest/gtest.h>

#include <array>

#include "libbake/planes/program_of.h"
#include "tests/libbake/draw/painter.h"

namespace texbake {
namespace {

// Computed by integer arithmetic in another language.
TEST(Hash, PermutationHasItsPinnedValues) {
  glsl::Program program;
  EXPECT_EQ(program.pcg(0u), 0x07bb2fe2u);
  EXPECT_EQ(program.pcg(1u), 0xa8beea3cu);
  EXPECT_EQ(program.pcg(2u), 0x7a7ecc88u);
  EXPECT_EQ(program.pcg(42u), 0x48f432ffu);
  EXPECT_EQ(program.pcg(0x7fffffffu), 0xe99f49ceu);
  EXPECT_EQ(program.pcg(0x80000000u), 0x21c72646u);
  EXPECT_EQ(program.pcg(0xffffffffu), 0xe62a4902u);
}

TEST(Hash, OfPatchTileAndSeedHasItsPinnedValues) {
  glsl::Program program;
  EXPECT_EQ(program.content_hash(0u, {0u, 0u}, 0u), 0x8d324821u);
  EXPECT_EQ(program.content_hash(3u, {0u, 0u}, 1u), 0x5351b602u);
  EXPECT_EQ(program.content_hash(3u, {1u, 0u}, 1u), 0x1c7e5facu);
  EXPECT_EQ(program.content_hash(3u, {0u, 1u}, 1u), 0x41ac35b0u);
  EXPECT_EQ(program.content_hash(0u, {0xffffffffu, 0xffffffffu}, 7u), 0x782dcc03u);
  EXPECT_EQ(program.content_hash(15u, {0x80000000u, 0x7fffffffu}, 0xdeadbeefu), 0x797485b8u);
  EXPECT_EQ(program.content_hash(65535u, {123456789u, 987654321u}, 42u), 0xbd0afbecu);
}

glsl::Program program_with(uint32_t count, uint32_t seed) {
  glsl::Program program;
  program.content_count = count;
  program.seed = seed;
  return program;
}

/// Σ (observed − expected)² / expected.
template <size_t N>
double chi_square(const std::array<int, N>& observed) {
  double total = 0, sum = 0;
  for (const int count : observed) total += count;
  const double expected = total / N;
  for (const int count : observed) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(Hash, ContentsAreDrawnEquallyOften) {
  glsl::Program program = program_with(5, 77);
  std::array<int, 5> seen{};
  for (uint32_t y = 0; y < 100; ++y)
    for (uint32_t x = 0; x < 100; ++x)
      for (int patch = 0; patch < 16; ++patch)
        ++seen[static_cast<size_t>(program.drawn_content(patch, {x - 50u, y - 50u}))];
  EXPECT_LT(chi_square(seen), 18.5);  // 4 degrees of freedom: exceeded once in 1000 seeds
}

TEST(Hash, NeighboringTilesPatchesAndSeedsDrawIndependently) {
  glsl::Program program = program_with(4, 5), other = program_with(4, 6);
  std::array<int, 16> beside{}, below{}, next_patch{}, next_seed{};
  for (uint32_t y = 0; y < 128; ++y)
    for (uint32_t x = 0; x < 128; ++x) {
      const int here = program.drawn_content(3, {x, y}) * 4;
      ++beside[static_cast<size_t>(here + program.drawn_content(3, {x + 1, y}))];
      ++below[static_cast<size_t>(here + program.drawn_content(3, {x, y + 1}))];
      ++next_patch[static_cast<size_t>(here + program.drawn_content(4, {x, y}))];
      ++next_seed[static_cast<size_t>(here + other.drawn_content(3, {x, y}))];
    }
  constexpr double kLimit = 37.7;  // 15 degrees of freedom: exceeded once in 1000 seeds
  EXPECT_LT(chi_square(beside), kLimit);
  EXPECT_LT(chi_square(below), kLimit);
  EXPECT_LT(chi_square(next_patch), kLimit);
  EXPECT_LT(chi_square(next_seed), kLimit);
}

}  // namespace
}  // namespace texbake
