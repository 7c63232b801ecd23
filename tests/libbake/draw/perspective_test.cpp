#include "libbake/draw/perspective.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/error.h"
#include "libbake/draw/view_program.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/levels.h"
#include "small_tile.h"

namespace texbake {
namespace {

EvaluatorPlanes leveled(V2i size, int contents, uint64_t seed) {
  EvaluatorPlanes planes = random_tile(size, contents, Contents::moved, seed).planes();
  return planes;
}

Perspective view_of(int width, int height) {
  Perspective view;
  view.width = width;
  view.height = height;
  view.seed = 3;
  return view;
}

glsl::Sight sight(const EvaluatorPlanes& planes, const Perspective& view, float x, float y) {
  glsl::PerspectiveProgram program = perspective_program_of(planes, view);
  return program.sight_at({{view.origin_x.tile, view.origin_y.tile},
                           {static_cast<int>(view.origin_x.offset_256), static_cast<int>(view.origin_y.offset_256)}},
                          x, y);
}

/// Texels from the point under the camera at which a pixel sees the plane.
Imath::V2d seen(const EvaluatorPlanes& planes, const Perspective& view, float x, float y) {
  const glsl::Probes probes = sight(planes, view, x, y).probes;
  const auto from = [](const TileOffset& origin, uint32_t tile, int offset, int side) {
    const double repetitions = static_cast<int32_t>(tile - origin.tile);
    return repetitions * side + (offset - static_cast<double>(origin.offset_256)) / 256;
  };
  return {from(view.origin_x, probes.at.tile.x, probes.at.offset.x, planes.size.x),
          from(view.origin_y, probes.at.tile.y, probes.at.offset.y, planes.size.y)};
}

TEST(Perspective, LookingStraightDownShowsTheWindow) {
  const EvaluatorPlanes planes = leveled({64, 32}, 5, 70);
  Perspective view = view_of(120, 80);
  view.pitch_deg = 90;
  view.fov_deg = 90;
  view.height_texels = 40;  // tan 45° · 40 texels are 40 pixels: one to a texel
  view.origin_x = tile_offset(int64_t{1} << 40, 0, 64);
  view.origin_y = tile_offset(-1000, 0, 32);
  Window window;
  window.origin_x = tile_offset((int64_t{1} << 40) - 60, 0, 64);
  window.origin_y = tile_offset(-1040, 0, 32);
  window.width = 120;
  window.height = 80;
  window.seed = 3;
  view.filter = window.filter = Filter::nearest;
  EXPECT_EQ(render_perspective_rows(planes, planes.base, view, 0, 80), render_rows(planes, window, 0, 80));
}

TEST(Perspective, TheHorizonIsAtTheHeightThatPitchSays) {
  const EvaluatorPlanes planes = leveled({32, 32}, 3, 71);
  Perspective view = view_of(30, 100);
  view.fov_deg = 90;
  for (const auto& [pitch, rows_of_sky] : {std::pair(0.0, 50), {45.0, 0}, {-45.0, 100}, {26.565051177, 25}}) {
    view.pitch_deg = pitch;  // atan ½: half of the upper half
    const Frame frame = perspective_frame(planes, planes.base, view);
    int sky = 0;
    for (int y = 0; y < 100; ++y) sky += frame.decisions(15, y) == PixelDecision{};
    EXPECT_NEAR(sky, rows_of_sky, 1) << pitch;
  }
}

TEST(Perspective, YawTurnsFromUpInTheTextureToItsRight) {
  const EvaluatorPlanes planes = leveled({32, 32}, 3, 72);
  Perspective view = view_of(101, 101);
  view.pitch_deg = 45;
  view.height_texels = 100;
  const auto ahead = [&](double yaw) {
    view.yaw_deg = yaw;
    return seen(planes, view, 50.5f, 50.5f);
  };
  EXPECT_NEAR(ahead(0).x, 0, 0.1);
  EXPECT_NEAR(ahead(0).y, -100, 0.1);
  EXPECT_NEAR(ahead(90).x, 100, 0.1);
  EXPECT_NEAR(ahead(90).y, 0, 0.1);
  view.yaw_deg = 90;  // to the right of what lies on the right is what lies below
  EXPECT_GT(seen(planes, view, 80, 50).y, 10);
}

TEST(Perspective, ProbesFollowTheFootprintOfAPixel) {
  const EvaluatorPlanes planes = leveled({64, 64}, 3, 73);
  Perspective view = view_of(200, 100);
  view.yaw_deg = 30;
  view.pitch_deg = 12;
  view.height_texels = 2000;
  for (const auto& [x, y] : {std::pair(100.5f, 50.5f), {20.5f, 90.5f}, {190.5f, 40.5f}}) {
    // The footprint by finite differences, half a pixel to each side.
    const Imath::V2d a = seen(planes, view, x + 0.5f, y) - seen(planes, view, x - 0.5f, y);
    const Imath::V2d b = seen(planes, view, x, y + 0.5f) - seen(planes, view, x, y - 0.5f);
    const double sum = a.length2() + b.length2(), area = std::abs(a.x * b.y - a.y * b.x);
    const double major = std::sqrt(sum / 2 + std::sqrt(sum * sum / 4 - area * area)), minor = area / major;
    const glsl::Probes probes = sight(planes, view, x, y).probes;
    const double length = std::hypot(probes.axis_256.x, probes.axis_256.y) / 256;
    EXPECT_NEAR(length / major, 1, 0.02);
    const double width = std::max(minor, major / 16);
    EXPECT_NEAR(probes.level_256, std::min(256 * std::log2(width), 256.0 * 7), 2 + 256 * 0.03);
    EXPECT_GE(width * (1 << probes.halvings), major * 0.98);
    EXPECT_LT(width * (1 << probes.halvings), major * 2.02);
  }
}

TEST(Perspective, TheIntegerLogarithmIsRight) {
  glsl::PerspectiveProgram program;
  for (float x = 0.001f; x < 1e6f; x *= 1.37f) EXPECT_NEAR(program.log2_256(x), 256 * std::log2(x), 3) << x;
  EXPECT_EQ(program.log2_256(8), 3 * 256);
}

/// Mean over the rows of |mean color of the row − that of the truth|, and the mean distance of pixels.
struct Error2 {
  double bias = 0, distance = 0;
};
Error2 error_of(const Image<V3f>& found, const Image<V3f>& truth) {
  Error2 error;
  V3f bias(0);
  for (size_t i = 0; i < found.size(); ++i) {
    const V3f d = found.data()[i] - truth.data()[i];
    bias += d;
    error.distance += d.length() / static_cast<double>(found.size());
  }
  error.bias = bias.length() / static_cast<double>(found.size());
  return error;
}

TEST(Perspective, FilteredViewsApproachTheSupersampledTruth) {
  const EvaluatorPlanes planes = leveled({64, 64}, 5, 74);
  Perspective view = view_of(48, 32);
  view.pitch_deg = 25;
  view.height_texels = 300;
  const Image<V3f> truth = supersampled_perspective_rows(planes, planes.base, view, 24, 0, 32);
  const auto error = [&](Filter filter) {
    view.filter = filter;
    return error_of(render_perspective_rows(planes, planes.base, view, 0, 32), truth);
  };
  const Error2 bilinear = error(Filter::bilinear), anisotropic = error(Filter::anisotropic);
  EXPECT_LT(anisotropic.distance, 0.15 * bilinear.distance) << "white noise, 0 … 4";
  // Noise of standard deviation 1.15 over a million texels, thrice.
  EXPECT_LT(anisotropic.bias, 3 * 1.15 / 1000);
  EXPECT_LT(anisotropic.distance, error(Filter::trilinear).distance * 1.5);
}

TEST(Perspective, CutsIntoRowsDoNotShowAndRepetitionsOfOneContentAreAlike) {
  const EvaluatorPlanes planes = leveled({32, 64}, 1, 75);
  Perspective view = view_of(40, 30);
  const Image<V3f> whole = render_perspective_rows(planes, planes.base, view, 0, 30);
  const Image<V3f> lower = render_perspective_rows(planes, planes.base, view, 17, 30);
  EXPECT_TRUE(std::equal(lower.begin(), lower.end(), whole.row(17)));
  view.origin_x.tile = 0xfffffff0u;
  view.origin_y.tile = 0x80000000u;
  EXPECT_EQ(render_perspective_rows(planes, planes.base, view, 0, 30), whole);
}

TEST(Perspective, AFrameHoldsTheSamePicture) {
  const EvaluatorPlanes planes = leveled({64, 64}, 5, 76);
  const Perspective view = view_of(60, 40);
  const Image<V3f> rows = render_perspective_rows(planes, planes.base, view, 0, 40);
  const Frame frame = perspective_frame(planes, planes.base, view);
  for (size_t i = 0; i < rows.size(); ++i) {
    const glsl::vec4& v = frame.values.data()[i];
    EXPECT_EQ(V3f(v.x, v.y, v.z), rows.data()[i]);
  }
}

TEST(Perspective, ACameraOutsideItsRangeIsRefused) {
  const auto refuses = [](auto&& spoil) {
    Perspective view = view_of(8, 8);
    spoil(view);
    try {
      check_perspective(view, {32, 32});
      return false;
    } catch (const Error& error) {
      return error.kind() == ErrorKind::usage;
    }
  };
  EXPECT_FALSE(refuses([](Perspective&) {}));
  EXPECT_TRUE(refuses([](Perspective& v) { v.width = 0; }));
  EXPECT_TRUE(refuses([](Perspective& v) { v.height_texels = 0; }));
  EXPECT_TRUE(refuses([](Perspective& v) { v.pitch_deg = std::nan(""); }));
  EXPECT_TRUE(refuses([](Perspective& v) { v.fov_deg = 180; }));
  EXPECT_TRUE(refuses([](Perspective& v) { v.origin_x.offset_256 = 32 * 256; }));
}

}  // namespace
}  // namespace texbake
