// Tests shaders/content.glsl: decisions and sources.
#include <gtest/gtest.h>

#include "libbake/planes/prepare.h"
#include "libbake/planes/program_of.h"
#include "tests/libbake/draw/painter.h"

namespace texbake {
namespace {

using glsl::Decision;
using glsl::Texel;

Texel texel_of(int64_t x, int64_t y, V2i n) {
  const int64_t kx = Painter::floor_div(x, n.x), ky = Painter::floor_div(y, n.y);
  return {{static_cast<uint32_t>(kx), static_cast<uint32_t>(ky)},
          {static_cast<int>(x - kx * n.x), static_cast<int>(y - ky * n.y)}};
}

TEST(Content, DecisionsEqualTheForwardPainters) {
  const V2i n(40, 24);
  for (const int64_t far : {int64_t{0}, (int64_t{1} << 32) * n.x, -(int64_t{1} << 31) * n.x}) {
    const SmallTile tile = random_tile(n, 7, Contents::turned, 11);
    const EvaluatorPlanes planes = tile.planes();
    glsl::Program program = program_of(planes, 3);
    const Painting painting = Painter(tile, 3).paint(far - 60, far - 60, 120, 120);
    for (int j = 0; j < 120; ++j)
      for (int i = 0; i < 120; ++i) {
        const Texel texel = texel_of(far - 60 + i, far - 60 + j, n);
        const Decision decision = program.decide(texel);
        const glsl::Source source = program.source_of(texel, decision);
        ASSERT_EQ(decision.patch_idx, painting.patch(i, j));
        ASSERT_EQ(decision.content, painting.content(i, j));
        ASSERT_EQ(V2i(source.nearest.x, source.nearest.y), painting.source(i, j));
      }
  }
}

TEST(Content, HalvesOfAPatchAcrossABorderAgree) {
  const SmallTile tile = random_tile({32, 32}, 64, Contents::moved, 12);
  const EvaluatorPlanes planes = tile.planes();
  glsl::Program program = program_of(planes, 4);
  int across = 0;
  for (int64_t y = -40; y < 40; ++y)
    for (int64_t x = -40; x < 40; ++x) {
      const Texel here = texel_of(x, y, {32, 32}), right = texel_of(x + 1, y, {32, 32});
      const Decision a = program.decide(here), b = program.decide(right);
      if (a.patch_idx != b.patch_idx) continue;
      EXPECT_EQ(a.content, b.content) << "at " << x << ", " << y;
      across += here.tile.x != right.tile.x;
    }
  EXPECT_GT(across, 20) << "some patch lies across a border of the tile";
}

TEST(Content, AnotherSeedChangesContentsNeverPatches) {
  const SmallTile tile = random_tile({32, 32}, 5, Contents::moved, 13);
  const EvaluatorPlanes planes = tile.planes();
  glsl::Program one = program_of(planes, 1), two = program_of(planes, 2);
  int changed = 0;
  for (int64_t y = 0; y < 64; ++y)
    for (int64_t x = 0; x < 64; ++x) {
      const Decision a = one.decide(texel_of(x, y, {32, 32})), b = two.decide(texel_of(x, y, {32, 32}));
      EXPECT_EQ(a.patch_idx, b.patch_idx);
      changed += a.content != b.content;
    }
  EXPECT_GT(changed, 64 * 64 / 2);
}

TEST(Content, PatchesOfOneTileDrawTheirContentsOneByOne) {
  // One draw for a whole tile would give 64 of 64 tiles a single number.
  const SmallTile tile = random_tile({32, 32}, 5, Contents::moved, 14);
  const EvaluatorPlanes planes = tile.planes();
  glsl::Program program = program_of(planes, 1);
  int uniform_tiles = 0;
  for (uint32_t k = 0; k < 64; ++k) {
    bool uniform = true;
    for (int patch = 1; patch < planes.patch_count; ++patch)
      uniform = uniform && program.drawn_content(patch, {k, 7u}) == program.drawn_content(0, {k, 7u});
    uniform_tiles += uniform;
  }
  EXPECT_EQ(uniform_tiles, 0);
}

/// One patch about center (16, 16) of a 64 × 64 tile, shown with one turned content.
struct OneContent {
  EvaluatorPlanes planes;
  glsl::Program program;
  explicit OneContent(const Content& content) {
    Image<V3f> base(64, 64);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) base(x, y) = V3f(static_cast<float>(x), static_cast<float>(y), 0);
    EvaluatorInput input;
    input.base = base;
    planes = prepare(input);
    planes.centers(0, 0) = {16, 16, 0, 0};
    const V2i t = wrap(content.translation, V2i(64, 64));
    planes.contents(0, 0) = {t.x | t.y << 16, static_cast<int>(content.scale * 65536), content.a, content.b};
    program = program_of(planes, 0);
  }
  glsl::Source at(int dx, int dy) { return program.texel_source({{0u, 0u}, {16 + dx, 16 + dy}}); }
};

TEST(Content, AQuarterTurnShowsWhatLiesAQuarterTurnBack) {
  // Turned from x towards y: what lay to the right of the center, at (5, 0), shows below it, at (0, 5).
  OneContent turned(turned_content({10, 20}, 2, 1.0f));
  const glsl::Source source = turned.at(0, 5);
  EXPECT_EQ(source.texel.x, 16 + 10 + 5);
  EXPECT_EQ(source.texel.y, 16 + 20);
  EXPECT_EQ(source.fraction.x, 0);
  EXPECT_EQ(source.nearest.x, source.texel.x);
}

TEST(Content, AHalfSizeContentShowsTwiceTheArea) {
  OneContent small(turned_content({0, 0}, 0, 0.5f));
  EXPECT_EQ(small.at(5, -3).texel.x, 16 + 10);
  EXPECT_EQ(small.at(5, -3).texel.y, 16 - 6);
}

TEST(Content, AnEighthTurnBlendsBetweenTexels) {
  OneContent turned(turned_content({0, 0}, 1, 1.0f));
  // R(−θ) (7, 0), y down: 4.95 texels to the right and 4.95 up.
  const glsl::Source source = turned.at(7, 0);
  const double x = source.texel.x + source.fraction.x / 256.0 - 16, y = source.texel.y + source.fraction.y / 256.0 - 16;
  EXPECT_NEAR(x, 4.9497, 1.0 / 256);
  EXPECT_NEAR(y, -4.9497, 1.0 / 256);
  EXPECT_EQ(source.nearest.x, 16 + 5);
  EXPECT_EQ(source.nearest.y, 16 - 5);
}

TEST(Content, NormalsTurnWithTheirContentAlone) {
  glsl::Program program;
  const glsl::vec4 east(1, 0, 0.5f, 0);
  for (int eighths = 0; eighths < 8; ++eighths)
    for (const float up : {1.0f, -1.0f}) {
      const Content content = turned_content({3, 4}, eighths, 0.75f);
      glsl::Source source{};
      source.matrix = {content.a, content.b};
      source.scale = static_cast<int>(content.scale * 65536);
      const glsl::vec4 turned = program.turned_normal(east, source, up);
      // Clockwise as seen: with y up, an angle of −θ.
      const double angle = eighths * -0.78539816339744831;
      EXPECT_NEAR(turned.x, std::cos(angle), 1e-6);
      EXPECT_NEAR(turned.y * up, std::sin(angle), 1e-6);
      EXPECT_EQ(turned.z, 0.5f);
      const glsl::vec4 turned_north = program.turned_normal({0, up, 0.5f, 0}, source, up);
      EXPECT_NEAR(turned_north.x, -std::sin(angle), 1e-6);
      EXPECT_NEAR(turned_north.y * up, std::cos(angle), 1e-6);
    }
}

}  // namespace
}  // namespace texbake
