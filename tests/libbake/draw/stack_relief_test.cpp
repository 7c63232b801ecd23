#include <gtest/gtest.h>

#include <cmath>

#include "libbake/draw/stack_perspective.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/stack_levels.h"
#include "small_stack.h"

namespace texbake {
namespace {

constexpr Direction kLight{-1, -1, 1.4f};

/// A coarse scale with heights and a fine one without, or the coarse one alone.
struct HighStack {
  ScaleTile coarse = random_scale({32, 32}, 1, Contents::moved, 3),
            fine = random_scale({16, 16}, 3, Contents::moved, 4);
  Image<float> height{32, 32}, normal[3];
  ScaleTransfer transfer{.ratio = 8};
  bool is_stack = true;

  template <class Height>
  explicit HighStack(const Height& of) {
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) height(x, y) = static_cast<float>(of(x, y));
  }
  /// Those of the heights, +y up, for a depth.
  void add_normals(double depth) {
    for (Image<float>& channel : normal) channel = Image<float>(32, 32);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        const auto at = [&](int i, int j) { return depth * double{height((i + 32) % 32, (j + 32) % 32)}; };
        const double dx = (at(x + 1, y) - at(x - 1, y)) / 2, dy = (at(x, y + 1) - at(x, y - 1)) / 2;
        const double length = std::sqrt(1 + dx * dx + dy * dy);
        normal[0](x, y) = static_cast<float>(-dx / length);
        normal[1](x, y) = static_cast<float>(dy / length);
        normal[2](x, y) = static_cast<float>(1 / length);
      }
  }
  EvaluatorInput coarse_input() const {
    EvaluatorInput input = coarse.input();
    input.maps.push_back({"height", MapKind::height, {height}});
    if (!normal[0].empty()) input.maps.push_back({"normal", MapKind::normal_opengl, {normal[0], normal[1], normal[2]}});
    return input;
  }
  StackPlanes planes() const {
    std::vector<StackScale> scales = {{coarse_input(), nullptr}};
    if (is_stack) scales.push_back({fine.input(), &transfer});
    StackPlanes planes = prepare_stack(scales);
    return planes;
  }
  ReliefPlanes relief(const ReliefOptions& options) const { return relief_planes(coarse_input(), options, kLight); }
};

double wave(double x, double y) {
  return 0.5 + 0.3 * std::sin(2 * M_PI * (x + 0.5) / 32) + 0.2 * std::cos(2 * M_PI * (y + 0.5) / 16);
}

Perspective view_from(double height_texels) {
  Perspective view;
  view.width = 60;
  view.height = 40;
  view.seed = 3;
  view.height_texels = height_texels;
  view.pitch_deg = 30;
  view.filter = Filter::trilinear;
  return view;
}

Image<V3f> drawn(const StackPlanes& planes, const ReliefPlanes* relief, const Perspective& view) {
  return render_stack_perspective_rows(planes, relief, view, 0, view.height);
}

TEST(StackRelief, AFlatHeightGivesNoRelief) {
  for (const bool is_stack : {true, false}) {
    HighStack stack([](int, int) { return 0.4; });
    stack.is_stack = is_stack;
    const StackPlanes planes = stack.planes();
    const ReliefPlanes relief = stack.relief({.depth_px = 20});
    for (const double height : {30, 300, 3000})
      EXPECT_TRUE(drawn(planes, &relief, view_from(height)) == drawn(planes, nullptr, view_from(height))) << height;
  }
}

TEST(StackRelief, AFlatNormalMapLightsNothing) {
  HighStack stack([](int, int) { return 0.4; });
  stack.add_normals(1);
  const StackPlanes planes = stack.planes();
  const ReliefPlanes relief = stack.relief({.depth_px = 20, .shade_by = ShadeBy::normal});
  EXPECT_TRUE(drawn(planes, &relief, view_from(100)) == drawn(planes, nullptr, view_from(100)));
}

TEST(StackRelief, WhereAPixelIsAsLargeAsTheReliefNothingMoves) {
  const HighStack stack(wave);
  const StackPlanes planes = stack.planes();
  const ReliefPlanes relief = stack.relief({.depth_px = 4, .shade_by = ShadeBy::none});
  Perspective far = view_from(40000);  // of the finest scale: 5000 of the coarsest, a pixel at least 80
  EXPECT_TRUE(drawn(planes, &relief, far) == drawn(planes, nullptr, far));
  EXPECT_FALSE(drawn(planes, &relief, view_from(400)) == drawn(planes, nullptr, view_from(400)));
}

TEST(StackRelief, ANormalMapOfTheHeightsShadesAsTheHeightsDo) {
  HighStack stack(wave);
  stack.add_normals(6);
  const StackPlanes planes = stack.planes();
  const ReliefPlanes by_height = stack.relief({.depth_px = 6}),
                     by_normal = stack.relief({.depth_px = 6, .shade_by = ShadeBy::normal});
  Perspective view = view_from(160);
  view.pitch_deg = 80;
  const Image<V3f> a = drawn(planes, &by_height, view), b = drawn(planes, &by_normal, view);
  double difference = 0, light = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    difference += (a.data()[i] - b.data()[i]).length();
    light += a.data()[i].length();
  }
  EXPECT_LT(difference, 0.02 * light);  // heights between texels are bilinear, and so are normals
}

TEST(StackRelief, TheLightFromAfarIsTheMeanOfTheLightFromNear) {
  HighStack stack(wave);
  for (V3f& color : stack.coarse.tile.base) color = V3f(1);
  stack.is_stack = false;
  const StackPlanes planes = stack.planes();
  const ReliefPlanes relief = stack.relief({.depth_px = 6});
  const auto mean_light = [&](double height) {
    Perspective view = view_from(height);
    view.pitch_deg = 90;
    view.fov_deg = 5;  // no slope is hidden behind another
    view.width = view.height = 64;
    double sum = 0;
    for (const V3f& color : drawn(planes, &relief, view)) sum += double{color.x} / (64 * 64);
    return sum;
  };
  // 64 texels across: two waves each way; then 32 texels to a pixel, and the mean of all.
  const double near = mean_light(32 / std::tan(2.5 * M_PI / 180));
  EXPECT_LT(near, 0.97);
  EXPECT_NEAR(mean_light(1024 / std::tan(2.5 * M_PI / 180)), near, 0.01);
  EXPECT_NEAR(mean_light(1e6), near, 0.01);
}

TEST(StackRelief, FilteredReliefApproachesTheSupersampledTruth) {
  HighStack stack(wave);
  for (V3f& color : stack.coarse.tile.base) color = V3f(1);
  stack.is_stack = false;
  const StackPlanes planes = stack.planes();
  const ReliefPlanes relief = stack.relief({.depth_px = 3});
  Perspective view = view_from(40);
  view.pitch_deg = 60;
  view.filter = Filter::anisotropic;
  const Image<V3f> truth = supersampled_stack_perspective_rows(planes, &relief, view, 8, 0, view.height);
  const Image<V3f> found = drawn(planes, &relief, view), flat = drawn(planes, nullptr, view);
  double error = 0, of_flat = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    error += (found.data()[i] - truth.data()[i]).length();
    of_flat += (flat.data()[i] - truth.data()[i]).length();
  }
  EXPECT_LT(error, 0.5 * of_flat);
}

}  // namespace
}  // namespace texbake
