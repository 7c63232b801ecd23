#include "libbake/content/patch_border.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

using ::testing::ElementsAre;

TEST(PatchBorders, ReachTwoTexelsBeyondTheBorderOnBothSides) {
  // One row on a torus: the border texels of 0 are columns 0 and 9, those of 1 are 10 and 19.
  const auto idx = twin::digits<uint32_t>("00000000001111111111");
  const PatchBorders borders = patch_borders(idx, 2);
  std::string sets;
  for (const uint32_t set : borders.set_idx) {
    const auto& patches = borders.sets[set];
    sets += patches.empty() ? '.' : patches.size() == 2 ? 'b' : static_cast<char>('0' + patches[0]);
  }
  EXPECT_EQ(sets, "bb0....0bbbb1....1bb");
  EXPECT_THAT(borders.texel_counts, ElementsAre(10u, 10u));
}

TEST(PatchBorders, AreTheDilatedBordersOfTheObviousLoop) {
  for (const V2i& size : {V2i(40, 31), V2i(17, 64), V2i(4, 3)}) {
    const Image<uint32_t> idx = twin::random_patches(size.x, size.y, 5, 7);
    const PatchBorders borders = patch_borders(idx, 5);
    for (uint32_t patch = 0; patch < 5; ++patch) {
      std::vector<V2i> found;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
          if (std::ranges::count(borders.sets[borders.set_idx(x, y)], patch)) found.emplace_back(x, y);
      EXPECT_EQ(found, twin::dilated_border(idx, patch));
      EXPECT_EQ(found.size(), borders.texel_counts[patch]);
    }
  }
}

TEST(PatchBorders, APatchThatCoversTheTorusHasNone) {
  const PatchBorders borders = patch_borders(Image<uint32_t>(8, 8), 1);
  EXPECT_THAT(borders.texel_counts, ElementsAre(0u));
}

}  // namespace
}  // namespace texbake
