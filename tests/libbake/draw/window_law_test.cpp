// The law of windows: any window equals the same part of a larger one.
#include <gtest/gtest.h>

#include "libbake/draw/drawing.h"
#include "libbake/draw/window_part.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

constexpr Filter kEveryFilter[] = {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic};

/// Draws a window whole and in a part, and counts pixels that differ.
int differing_pixels(const DrawnMaterial& material, const DrawRequest& whole, V2i tile_size, V2i first, V2i size) {
  DrawRequest part = whole;
  part.view = part_of(std::get<Window>(whole.view), tile_size, first, size);
  const Image<V3f> in_whole = Drawing(material, whole).rows(first.y, first.y + size.y);
  const Image<V3f> alone = Drawing(material, part).rows(0, size.y);
  int differing = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      if (alone(x, y) != in_whole(first.x + x, y)) ++differing;
  return differing;
}

/// A wide window somewhere, of random step and filter, and a part of it.
struct RandomView {
  Window window;
  V2i first;
  V2i size{12, 10};

  RandomView(Random& random, V2i tile_size, uint32_t least_256, uint32_t most_256) {
    const auto coordinate = [&] { return static_cast<int64_t>(random.below(1u << 30)) * 50 - (int64_t{1} << 34); };
    window.origin_x = tile_offset(coordinate(), random.below(256), tile_size.x);
    window.origin_y = tile_offset(coordinate(), random.below(256), tile_size.y);
    window.step_256 = least_256 + random.below(most_256 - least_256);
    window.width = 2000;
    window.height = 40;
    window.seed = random.next();
    window.filter = kEveryFilter[random.below(4)];
    first = {1900 + static_cast<int>(random.below(80)), static_cast<int>(random.below(30))};
  }
};

TEST(WindowLaw, HoldsForStacksOnBothSidesOfEveryRatio) {
  Random random(71, 3);
  for (const int ratio : {2, 6, 16}) {
    const SmallStack stack = two_scales({.ratio = ratio}, Contents::turned);
    const DrawnMaterial material{stack.scales().back().input, stack.scales()};
    const V2i size = stack.tiles.back().tile.size();
    const auto far = static_cast<uint32_t>(ratio) * 256;
    for (int i = 0; i < 12; ++i) {
      const RandomView view = i % 2 == 0 ? RandomView(random, size, 30, far) : RandomView(random, size, far, 3 * far);
      EXPECT_EQ(differing_pixels(material, {.view = view.window}, size, view.first, view.size), 0)
          << "ratio " << ratio << ", step " << view.window.step_256 << ", " << enum_name(view.window.filter);
    }
  }
}

TEST(WindowLaw, HoldsForOneScaleDeformedOrNotWithReliefAndInManySamples) {
  Random random(72, 3);
  SmallTile tile = random_tile({40, 24}, 5, Contents::turned, 72);
  add_noise(tile, 3, 16, 72);
  tile.soft_border_px = 2;
  const Image<float> heights(40, 24, 0.5f);
  EvaluatorInput input = tile.input();
  input.maps.push_back({"height", MapKind::height, {heights}});
  const DrawnMaterial material{input, {{input}}};
  for (int i = 0; i < 24; ++i) {
    RandomView view(random, {40, 24}, 20, 2000);
    DrawRequest request;
    if (i % 3 == 1)
      view.window.deformation =
          deformation_of({.rotate_degrees = 33, .stretch_x = 1.7, .stretch_y = 0.6, .turbulence_texels = 9});
    if (i % 3 == 2) request.relief.options.depth_px = 4;
    if (i % 4 == 3) request.samples = 3;
    request.relief.viewer = {1, 0.5f, 1};
    request.view = view.window;
    EXPECT_EQ(differing_pixels(material, request, {40, 24}, view.first, view.size), 0)
        << i << ", step " << view.window.step_256 << ", " << enum_name(view.window.filter);
  }
}

}  // namespace
}  // namespace texbake
