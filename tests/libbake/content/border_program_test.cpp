#include "libbake/content/border_program.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

struct ProgramFixture {
  Image<uint8_t> classes = twin::random_classes(90, 75, 5, 1);
  ClassDistances distances = class_distances(twin::random_colors(5, 1));
  Image<uint32_t> patches = twin::random_patches(90, 75, 6, 1);
  PatchBorders borders = patch_borders(patches, 6);
  BorderProgram program = border_program(borders, classes, distances);
};

bool is_sum(const Segment& segment) { return segment.kind == SegmentKind::sum || segment.kind == SegmentKind::extend; }

TEST(BorderProgram, SumsEveryBorderTexelOnceForItsPatches) {
  const ProgramFixture f;
  Image<int> seen(90, 75);
  for (const Chunk& chunk : f.program) {
    int texels = 0;
    for (const Segment& segment : chunk.segments) {
      if (!is_sum(segment)) continue;
      for (int i = 0; i < segment.count; ++i, ++texels) {
        const V2i p = wrap(chunk.texel(segment.x + i, segment.y), V2i(90, 75));
        EXPECT_EQ(chunk.sums[segment.sum].patches, f.borders.sets[f.borders.set_idx(p.x, p.y)]);
        ++seen(p.x, p.y);
      }
    }
    EXPECT_EQ(texels, chunk.texel_count);
  }
  for (int y = 0; y < 75; ++y)
    for (int x = 0; x < 90; ++x) EXPECT_EQ(seen(x, y), f.borders.set_idx(x, y) != 0 ? 1 : 0);
}

TEST(BorderProgram, FetchesWhatItsSumsNeedBeforeTheyNeedIt) {
  const ProgramFixture f;
  for (const Chunk& chunk : f.program) {
    std::set<std::pair<int, int>> fetched;  // (y, x)
    std::set<std::pair<int, int>> columns;  // (middle row, x) of complete column sums
    for (const Segment& segment : chunk.segments)
      for (int x = segment.x; x < segment.x + segment.count; ++x) {
        const int y = segment.y;
        if (segment.kind == SegmentKind::fetch) {
          EXPECT_TRUE(fetched.insert({y, x}).second);
        }
        if (segment.kind == SegmentKind::slide) {
          EXPECT_TRUE(fetched.insert({y + kMaskRadius, x}).second);
          EXPECT_TRUE(columns.contains({y - 1, x}));
          EXPECT_TRUE(fetched.contains({y - 1 - kMaskRadius, x}));
          columns.insert({y, x});
        }
        if (segment.kind == SegmentKind::open) {
          for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy) EXPECT_TRUE(fetched.contains({y + dy, x}));
          columns.insert({y, x});
        }
        if (is_sum(segment)) {
          for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) EXPECT_TRUE(columns.contains({y, x + dx}));
        }
      }
  }
}

TEST(BorderProgram, RunsAlongItsBorders) {
  // Stripes that run down the tile and stripes that run across it, with the same steps.
  Image<uint32_t> down(48, 48), across(48, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) down(x, y) = across(y, x) = static_cast<uint32_t>(x / 24);
  const Image<uint8_t> classes(48, 48);
  const V3f colors[] = {{0, 0, 0}};
  const ClassDistances distances = class_distances(colors);
  const BorderProgram down_program = border_program(patch_borders(down, 2), classes, distances);
  const BorderProgram across_program = border_program(patch_borders(across, 2), classes, distances);
  EXPECT_EQ(down_program.at(0).rows, Rows::down);
  EXPECT_EQ(across_program.at(0).rows, Rows::across);
  EXPECT_EQ(down_program.at(0).segments.size(), across_program.at(0).segments.size());
}

TEST(BorderProgram, NoSumCanPass32Bits) {
  // Two classes at the largest distance everywhere: the greatest errors there are.
  Image<uint8_t> classes(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) classes(x, y) = static_cast<uint8_t>((x + y) % 2);
  const V3f colors[] = {{0, 0, 0}, {100, 0, 0}};
  const Image<uint32_t> patches = twin::random_patches(64, 64, 30, 2);
  for (const Chunk& chunk : border_program(patch_borders(patches, 30), classes, class_distances(colors)))
    for (size_t s = 0; s < chunk.sums.size(); ++s) {
      uint64_t texels = 0;
      for (const Segment& segment : chunk.segments) texels += is_sum(segment) && segment.sum == s ? segment.count : 0u;
      EXPECT_EQ(chunk.sums[s].bound, texels * 255 * 255 * 49);
      EXPECT_LE(chunk.sums[s].bound, UINT32_MAX);
    }
}

}  // namespace
}  // namespace texbake
