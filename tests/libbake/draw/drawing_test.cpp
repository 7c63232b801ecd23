#include "libbake/draw/drawing.h"

#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/draw/perspective.h"
#include "libbake/draw/relief_window.h"
#include "libbake/draw/stack_perspective.h"
#include "libbake/draw/stack_window.h"
#include "libbake/draw/supersample.h"
#include "libbake/draw/window_rows.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

constexpr V2i kSize(32, 64);

/// A tile with two maps.
struct Material {
  SmallTile tile = random_tile(kSize, 3, Contents::moved, 5);
  Image<float> rough{kSize.x, kSize.y, 0.5f};
  Image<float> heights{kSize.x, kSize.y, 0.0f};

  Material() {
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) heights(x, y) = static_cast<float>((x * 7 + y * 3) % 16) / 16.0f;
  }
  DrawnMaterial drawn() const {
    EvaluatorInput input = tile.input();
    input.maps.push_back({"roughness", MapKind::plain, {rough}});
    input.maps.push_back({"height", MapKind::height, {heights}});
    return {input, {{input}}};
  }
};

Window window_at(uint32_t step_256, Filter filter = Filter::trilinear) {
  Window window;
  window.step_256 = step_256;
  window.width = 20;
  window.height = 12;
  window.seed = 3;
  window.filter = filter;
  window.origin_x = tile_offset(-77, 0, kSize.x);
  window.origin_y = tile_offset(1000, 128, kSize.y);
  return window;
}

Perspective plane_view() {
  Perspective view;
  view.height_texels = 40;
  view.width = 24;
  view.height = 16;
  return view;
}

bool equal(const Image<V3f>& a, const Image<V3f>& b) {
  return a.width() == b.width() && a.height() == b.height() && std::equal(a.begin(), a.end(), b.begin());
}

ErrorKind kind_of_refusal(const DrawnMaterial& material, const DrawRequest& picture) {
  try {
    const Drawing drawing(material, picture);
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "expected a refusal";
  return ErrorKind::io;
}

TEST(Drawing, OneScaleIsDrawnAsItsPlanesAre) {
  const Material material;
  const EvaluatorPlanes planes = prepare(material.drawn().finest);
  for (const uint32_t step_256 : {256u, 1024u}) {
    const Window window = window_at(step_256);
    EXPECT_TRUE(equal(Drawing(material.drawn(), {.view = window}).rows(0, 12), render_rows(planes, window, 0, 12)));
    EXPECT_TRUE(equal(Drawing(material.drawn(), {.view = window, .map = "height"}).rows(3, 7),
                      render_map_rows(planes, *planes.map("height"), window, 3, 7)));
    EXPECT_TRUE(equal(Drawing(material.drawn(), {.view = window, .samples = 2}).rows(0, 12),
                      supersampled_rows(planes, planes.base, window, 2, 0, 12)));
  }
  const Perspective view = plane_view();
  EXPECT_TRUE(equal(Drawing(material.drawn(), {.view = view}).rows(0, 16),
                    render_perspective_rows(planes, planes.base, view, 0, 16)));
}

TEST(Drawing, SeveralScalesAndReliefAreDrawnAsAStackIs) {
  const SmallStack stack = two_scales({.ratio = 4});
  const DrawnMaterial material{stack.scales().back().input, stack.scales()};
  const StackPlanes planes = stack.planes();
  Window window = window_at(512);
  window.origin_x = window.origin_y = {};
  EXPECT_TRUE(equal(Drawing(material, {.view = window}).rows(0, 12), render_stack_rows(planes, window, 0, 12)));
  const Perspective view = plane_view();
  EXPECT_TRUE(equal(Drawing(material, {.view = view}).rows(0, 16),
                    render_stack_perspective_rows(planes, nullptr, view, 0, 16)));

  const Material single;
  DrawRequest lit{.view = window_at(256)};
  lit.relief.options.depth_px = 4;
  lit.relief.viewer = {1, 0, 1};
  const DrawnMaterial drawn = single.drawn();
  const ReliefPlanes relief = relief_planes(drawn.scales[0].input, lit.relief.options, lit.relief.light);
  EXPECT_TRUE(equal(Drawing(drawn, lit).rows(0, 12),
                    render_relief_rows(prepare_stack(drawn.scales), relief, {1, 0, 1}, window_at(256), 0, 12)));
}

TEST(Drawing, WhatDoesNotGoTogetherIsRefused) {
  const Material material;
  const DrawnMaterial drawn = material.drawn();
  Window deformed = window_at(256);
  deformed.deformation = deformation_of({.rotate_degrees = 30});
  Relief relief;
  relief.options.depth_px = 4;
  for (const DrawRequest& picture :
       std::initializer_list<DrawRequest>{{.view = deformed, .map = "roughness"},
                                          {.view = deformed, .show = Show::patches},
                                          {.view = deformed, .relief = relief},
                                          {.view = window_at(256), .map = "roughness", .show = Show::patches},
                                          {.view = window_at(256), .show = Show::patches, .samples = 2},
                                          {.view = plane_view(), .show = Show::patches},
                                          {.view = window_at(256), .map = "roughness", .relief = relief},
                                          {.view = window_at(256), .show = Show::patches, .relief = relief},
                                          {.view = window_at(256), .map = "rouhgness"},
                                          {.view = window_at(256), .show = Show::noise}})
    EXPECT_EQ(kind_of_refusal(drawn, picture), ErrorKind::usage);
  const SmallStack stack = two_scales({.ratio = 4});
  EXPECT_EQ(kind_of_refusal({stack.scales().back().input, stack.scales()}, {.view = deformed}), ErrorKind::usage);
}

TEST(Drawing, AMapThatIsMisspelledGetsASuggestion) {
  const Material material;
  try {
    Drawing(material.drawn(), {.view = window_at(256), .map = "rouhgness"});
    FAIL() << "expected a refusal";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"roughness\""), std::string::npos) << error.what();
  }
}

TEST(Drawing, PreparedPlanesHaveTheirLevels) {
  const Material material;
  const EvaluatorPlanes planes = prepare(material.drawn().finest);
  EXPECT_EQ(planes.first_level, 1) << "borders are hard";
  EXPECT_EQ(planes.level_count, 6);
  EXPECT_FALSE(planes.base.level_values.empty());
  for (const Plane& map : planes.maps) EXPECT_FALSE(map.level_values.empty()) << map.name;
  const StackPlanes stack = two_scales({.ratio = 4}).planes();
  EXPECT_GT(stack.level_count(0), 0);
  EXPECT_FALSE(stack.base_levels.empty());
}

}  // namespace
}  // namespace texbake
