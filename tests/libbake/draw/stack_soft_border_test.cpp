// Soft borders of patches in stacks of scales.
#include <gtest/gtest.h>

#include "libbake/draw/relief_window.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/program_of.h"
#include "libbake/planes/soft_cover.h"
#include "libbake/planes/stack_levels.h"
#include "small_stack.h"
#include "stack_painter.h"

namespace texbake {
namespace {

constexpr int kBorder = 2;

std::vector<StackScale> soft_scales(const SmallStack& stack, int border_px = kBorder) {
  std::vector<StackScale> scales = stack.scales();
  for (StackScale& scale : scales) scale.input.soft_border_px = border_px;
  return scales;
}

Window texels(int side) {
  Window window;
  window.origin_x = {7, 5 * 256};
  window.origin_y = {0xffffffffu, 3 * 256};
  window.width = window.height = side;
  window.seed = 3;
  return window;
}

TEST(StackSoftBorder, AStackOfOneScaleIsThatScale) {
  SmallStack stack;
  stack.add(random_scale({64, 48}, 3, Contents::turned, 21));
  const std::vector<StackScale> scales = soft_scales(stack);
  const StackPlanes planes = prepare_stack(scales);
  const EvaluatorPlanes single = prepare(scales[0].input);
  Window window = texels(90);
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
    window.filter = filter;
    window.step_256 = filter == Filter::trilinear ? 700 : 200;
    EXPECT_TRUE(render_stack_rows(planes, window, 0, 90) == render_rows(single, window, 0, 90));
  }
}

TEST(StackSoftBorder, WithoutReliefATileWithHeightsIsDrawnAlike) {
  SmallStack stack;
  stack.add(random_scale({64, 48}, 3, Contents::turned, 22));
  std::vector<StackScale> scales = soft_scales(stack);
  const Image<float> flat(64, 48, 0.5f);
  scales[0].input.maps.push_back({"height", MapKind::height, {flat}});
  const ReliefPlanes relief = relief_planes(scales[0].input, {.depth_px = 9, .shade_by = ShadeBy::none}, {});
  const Window window = texels(60);
  EXPECT_TRUE(render_relief_rows(prepare_stack(scales), relief, {0, 0, 1}, window, 0, 60) ==
              render_rows(prepare(scales[0].input), window, 0, 60));
}

TEST(StackSoftBorder, OfOneTexelIsHard) {
  const SmallStack stack = two_scales({.ratio = 5, .weights = {0.5f, 1}}, Contents::turned);
  const StackPlanes hard = stack.planes(), soft = prepare_stack(soft_scales(stack, 1));
  const Window window = texels(60);
  EXPECT_TRUE(render_stack_rows(hard, window, 0, 60) == render_stack_rows(soft, window, 0, 60));
}

TEST(StackSoftBorder, WhereAllContentsAreTheSameNothingChanges) {
  for (const TransferMode mode : {TransferMode::fragment, TransferMode::texel, TransferMode::bilinear}) {
    SmallStack stack;
    stack.add(random_scale({32, 16}, 1, Contents::moved, 23));
    stack.add(random_scale({16, 32}, 1, Contents::moved, 24), {.ratio = 5, .mode = mode});
    const StackPlanes hard = stack.planes(), soft = prepare_stack(soft_scales(stack));
    const Window window = texels(60);
    const Image<V3f> a = render_stack_rows(hard, window, 0, 60), b = render_stack_rows(soft, window, 0, 60);
    // Values up to 8, sums of up to four of them: a few roundings.
    for (size_t i = 0; i < a.size(); ++i) EXPECT_LT((a.data()[i] - b.data()[i]).length(), 2e-5f);
  }
}

/// A flat fine scale shows what its patches take, each by its weight: every entry's fragment by the hard painter's
/// rules.
TEST(StackSoftBorder, PatchesTakeCoarseColorsByTheirWeights) {
  SmallStack stack;
  stack.add(random_scale({32, 32}, 1, Contents::moved, 25));
  ScaleTile fine = random_scale({32, 32}, 3, Contents::moved, 26);
  for (V3f& color : fine.tile.base) color = V3f(1);
  stack.add(std::move(fine), {.ratio = 4, .weights = {0.5f, 1}});
  const StackPlanes planes = prepare_stack(soft_scales(stack));
  const ScaleTile& tile = stack.tiles.back();
  const Image<V3f>& coarse = stack.tiles.front().tile.base;
  const SoftCover cover = soft_cover(tile.tile.planes().patch_plane, kBorder);
  const Painter painter(tile.tile, 3);
  glsl::Program program = program_of(planes, 3, {0, 0});
  const Partition& fragments = tile.fragments.partition;
  int shared = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const V2i p(x % 32, y % 32);
      V3f expected(1);
      const auto entries = cover.cover.at(p.x, p.y);
      shared += entries.size() > 1;
      for (size_t i = 0; i < entries.size(); ++i) {
        const int kx = x / 32 + (entries[i].owner & 3) - 1, ky = y / 32 + (entries[i].owner >> 2) - 1;
        const Content& content =
            tile.tile.contents.at(entries[i].patch_idx, painter.content_of(entries[i].patch_idx, kx, ky));
        const V2i source = wrap(p + content.translation, V2i(32));
        const uint32_t idx = fragments.idx(source.x, source.y);
        const OwnerOffset owner = fragments.owner(source.x, source.y);
        const V2i way = fragments.centers[idx] + V2i(owner.x * 32, owner.y * 32) - source;
        const V2i at = wrap(V2i((x + way.x + 128) / 4, (y + way.y + 128) / 4), V2i(32));
        const float taking = tile.fragments.fragments[idx].class_idx == 0 ? 0.5f : 1.0f;
        expected += (coarse(at.x, at.y) - V3f(1)) * (taking * cover.weights[cover.cover.first_at(p.x, p.y) + i]);
      }
      const glsl::vec4 found =
          program.scale_texel(1, {{static_cast<uint32_t>(x / 32), static_cast<uint32_t>(y / 32)}, {p.x, p.y}}, 1);
      EXPECT_LT((V3f(found.x, found.y, found.z) - expected).length(), 1e-5f) << x << " " << y;
    }
  EXPECT_GT(shared, 500);
}

/// What stands of a fine texture beside its mean, over a flat coarse one.
double variance(const StackPlanes& planes) {
  const Image<V3f> drawn = render_stack_rows(planes, texels(256), 0, 256);
  double sum = 0, squares = 0;
  for (const V3f& color : drawn) {
    sum += double{color.x};
    squares += double{color.x} * double{color.x};
  }
  const auto n = static_cast<double>(drawn.size());
  return squares / n - (sum / n) * (sum / n);
}

TEST(StackSoftBorder, DetailKeepsItsVariance) {
  SmallStack stack;
  stack.add(random_scale({32, 32}, 1, Contents::moved, 27));
  for (V3f& color : stack.tiles.front().tile.base) color = V3f(1);
  stack.add(random_scale({64, 64}, 5, Contents::moved, 28), {.ratio = 4});
  // Random texels: a plain blend would lose a third of what is shared, about half of the tile.
  EXPECT_NEAR(variance(prepare_stack(soft_scales(stack, 4))) / variance(stack.planes()), 1, 0.05);
}

TEST(StackSoftBorder, APassedColorWithoutVariationIsTheDominantOne) {
  SmallStack stack = two_scales({.ratio = 5, .variation = VariationFrom::fine});
  for (ScaleTile& tile : stack.tiles) tile.colors.palette.classes[1] = tile.colors.palette.classes[0];
  const StackPlanes soft = prepare_stack(soft_scales(stack));
  const V3f dominant = linear_from_luv(stack.tiles.front().colors.palette.classes[0].dominant);
  // One class: every coarse texel passes the same color, soft or hard.
  glsl::Program program = program_of(soft, 3, {0, 0});
  for (int x = 0; x < 32; ++x) {
    const glsl::vec4 passed = program.stacked_texel(0, {{0, 0}, {x, 7}}, 0);
    EXPECT_LT((V3f(passed.x, passed.y, passed.z) - dominant).length(), 1e-5f);
  }
}

}  // namespace
}  // namespace texbake
