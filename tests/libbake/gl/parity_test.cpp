#include "libbake/gl/parity.h"

#include <gtest/gtest.h>

#include "gl_test_context.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "tests/libbake/draw/small_tile.h"

namespace texbake {
namespace {

class Parity : public testing::TestWithParam<ShaderLanguage> {
 protected:
  void SetUp() override {
    context_ = test_context(GetParam());
    if (!context_) GTEST_SKIP() << "no OpenGL";
  }
  ParityReport check(EvaluatorPlanes planes, const ParityOptions& options) {
    const ParityReport report = check_parity(planes, *context_, options);
    EXPECT_EQ(report.differing_decisions, 0u) << report.driver;
    EXPECT_EQ(report.differing_bits, 0u) << report.driver;
    EXPECT_TRUE(report.equal());
    return report;
  }
  std::unique_ptr<GlContext> context_;
};

TEST_P(Parity, MovedContentsDifferInNoBitOverAMillionPoints) {
  const SmallTile tile = random_tile({96, 64}, 5, Contents::moved, 1);
  const ParityReport report = check(tile.planes(), {.windows = 16, .side = 256, .seed = 1});
  EXPECT_GE(report.points, 1u << 20);
  EXPECT_EQ(report.drawn_contents, 5u * static_cast<uint64_t>(tile.patches.partition.count())) << "every content";
}

TEST_P(Parity, TurnedAndScaledContentsDifferInNoBitOverAMillionPoints) {
  const SmallTile tile = random_tile({65, 97}, 16, Contents::turned, 2);
  const ParityReport report = check(tile.planes(), {.windows = 16, .side = 256, .seed = 2});
  EXPECT_GE(report.points, 1u << 20);
  EXPECT_EQ(report.drawn_contents, 16u * static_cast<uint64_t>(tile.patches.partition.count())) << "every content";
}

TEST_P(Parity, MapsOfEveryKindDifferInNoBit) {
  const SmallTile tile = random_tile({64, 64}, 16, Contents::turned, 3);
  const Image<V3f> noise = random_base({64, 64}, 99);
  Image<float> channels[3] = {Image<float>(64, 64), Image<float>(64, 64), Image<float>(64, 64)};
  for (int c = 0; c < 3; ++c)
    for (size_t i = 0; i < noise.size(); ++i) channels[c].data()[i] = noise.data()[i][c] * 0.37f - 0.7f;
  EvaluatorInput input = tile.input();
  for (const MapKind kind : {MapKind::normal_opengl, MapKind::normal_directx, MapKind::plain})
    input.maps.push_back({"map", kind, {channels[0], channels[1], channels[2]}});
  input.maps.push_back({"height", MapKind::height, {channels[0]}});
  check(prepare(input), {.windows = 8, .side = 128, .seed = 3});
}

TEST_P(Parity, NoiseDiffersInNoBitOverAMillionPoints) {
  for (int count = 1; count <= 4; ++count) {
    SmallTile tile = random_tile({65, 97}, 16, count % 2 == 0 ? Contents::turned : Contents::moved, 6);
    add_noise(tile, count, 64, 6);
    const ParityReport report = check(tile.planes(), {.windows = 4, .most_windows = 4, .side = 256, .seed = 6});
    EXPECT_GE(report.points, 1u << 18);
  }
}

TEST_P(Parity, DeformedWindowsDifferInNoBit) {
  SmallTile tile = random_tile({65, 97}, 16, Contents::turned, 7);
  add_noise(tile, 3, 64, 7);
  const EvaluatorPlanes planes = tile.planes();
  GlRenderer renderer(*context_, planes);
  for (Window window : parity_windows(planes.size, {.windows = 8, .side = 128, .seed = 7})) {
    window.deformation = deformation_of(
        {.rotate_degrees = window.seed % 360 * 1.0, .stretch_x = 1.7, .stretch_y = 0.6, .turbulence_texels = 24});
    const Frame expected = reference_frame(planes, window, planes.base);
    EXPECT_EQ(renderer.draw(window, planes.base).values, expected.values);
  }
}

TEST_P(Parity, SoftBordersDifferInNoBit) {
  const SmallTile tile = random_tile({64, 96}, 5, Contents::turned, 6);
  EvaluatorInput input = tile.input();
  input.soft_border_px = 4;
  check(prepare(input), {.windows = 12, .side = 128, .seed = 6});
}

TEST_P(Parity, ALargeTileDiffersInNoBit) {
  const SmallTile tile = random_tile({768, 768}, 8, Contents::turned, 4);
  check(tile.planes(), {.windows = 8, .side = 128, .seed = 4});
}

TEST_P(Parity, WithoutPatchesTheTileRepeats) {
  const Image<V3f> base = random_base({32, 48}, 5);
  EvaluatorInput input;
  input.base = base;
  const ParityReport report = check(prepare(input), {.windows = 4, .side = 128, .seed = 5});
  EXPECT_EQ(report.drawn_contents, 1u);
}

INSTANTIATE_TEST_SUITE_P(OpenGL, Parity, testing::Values(ShaderLanguage::glsl_330, ShaderLanguage::glsl_300_es),
                         [](const auto& which) {
                           return which.param == ShaderLanguage::glsl_330 ? "Core33" : "Embedded30";
                         });

}  // namespace
}  // namespace texbake
