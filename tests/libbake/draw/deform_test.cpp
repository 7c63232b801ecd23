#include "libbake/draw/deform.h"

#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "libbake/draw/compare.h"
#include "libbake/draw/frame.h"
#include "libbake/draw/supersample.h"
#include "libbake/draw/window_program.h"
#include "libbake/draw/window_rows.h"
#include "small_tile.h"

namespace texbake {
namespace {

Window deformed_window(V2i tile_size, int64_t x0, int64_t y0, V2i size, const DeformationRequest& request) {
  Window window;
  window.origin_x = tile_offset(x0, 0, tile_size.x);
  window.origin_y = tile_offset(y0, 0, tile_size.y);
  window.width = size.x;
  window.height = size.y;
  window.seed = 5;
  window.deformation = deformation_of(request);
  return window;
}

SmallTile tile_with_noise(uint64_t seed) {
  SmallTile tile = random_tile({40, 24}, 5, Contents::turned, seed);
  add_noise(tile, 3, 16, seed);
  return tile;
}

Image<V3f> render(const EvaluatorPlanes& planes, const Window& window) {
  return render_rows(planes, window, 0, window.height);
}

TEST(Deform, TheIdentityTakesEveryTexelFromItself) {
  const SmallTile tile = tile_with_noise(60);
  const EvaluatorPlanes planes = tile.planes();
  const Window window = deformed_window({40, 24}, -333, 1017, {64, 64}, {});
  glsl::Program program = program_of(planes, window);
  for (uint32_t y = 0; y < 64; ++y)
    for (uint32_t x = 0; x < 64; ++x) {
      const glsl::Position at = program.pixel_position(origin_of(window), 256, {x, y});
      const glsl::Texel texel = program.texel_at(at);
      EXPECT_EQ(program.deformed_value(program.base, glsl::kPlaneStructure, program.base_levels, at,
                                       glsl::kFilterBilinear, 0),
                program.layered_value(program.base, texel, program.texel_source(texel)));
    }
}

/// What a deformed window reads, with soft borders where they are wider than 0.
EvaluatorPlanes planes_apart(const SmallTile& tile, int soft_border_px) {
  EvaluatorInput input = tile.input();
  input.soft_border_px = soft_border_px;
  input.grain_apart = true;
  return prepare(input);
}

TEST(Deform, SoftBordersAreDeformedToo) {
  for (const bool has_noise : {false, true}) {
    SmallTile tile = random_tile({40, 24}, 5, Contents::turned, 66);
    if (has_noise) add_noise(tile, 3, 16, 66);
    const EvaluatorPlanes soft = planes_apart(tile, 3), hard = planes_apart(tile, 0);
    const Window whole = deformed_window({40, 24}, -333, 1017, {64, 64}, {});
    // By the quarter, every texel is a texel of the undeformed picture, borders and all; noise aside.
    const Window turned = deformed_window({40, 24}, 0, 0, {64, 64}, {.rotate_degrees = 90});
    Window plain = deformed_window({40, 24}, 0, -64, {64, 64}, {});
    const Image<V3f> found = render(soft, turned), expected = render(soft, plain), without = render(hard, turned);
    int differing = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        if (!has_noise) {
          EXPECT_EQ(found(x, y), expected(y, 63 - x));
        }
        if (found(x, y) != without(x, y)) ++differing;
      }
    EXPECT_GT(differing, 400) << "borders are soft";
    glsl::Program program = program_of(soft, whole);
    const int kind = plane_kind(soft.base.kind);
    for (int i = 0; i < 64; ++i) {
      const glsl::Position at = program.pixel_position(origin_of(whole), 256, {static_cast<uint32_t>(i), 7});
      EXPECT_EQ(program.deformed_value(program.base, kind, program.base_levels, at, glsl::kFilterBilinear, 0),
                program.texel_value(program.base, kind, program.base_levels, program.texel_at(at)))
          << "by the identity";
    }
  }
}

/// The mean difference of two pictures, and that of their means.
struct PictureDifference {
  double mean = 0;
  double bias = 0;
};

PictureDifference picture_difference(const Image<V3f>& a, const Image<V3f>& b) {
  PictureDifference found;
  for (size_t i = 0; i < a.size(); ++i) {
    found.mean += double{(a.data()[i] - b.data()[i]).length()};
    found.bias += double{a.data()[i].y} - double{b.data()[i].y};
  }
  found.mean /= static_cast<double>(a.size());
  found.bias /= static_cast<double>(a.size());
  return found;
}

TEST(Deform, FromAfarEveryFilterIsNearTheMeanOfManyPoints) {
  SmallTile tile = random_tile({64, 64}, 4, Contents::turned, 67);
  for (const bool has_noise : {false, true}) {
    if (has_noise) add_noise(tile, 2, 64, 67);
    const EvaluatorPlanes planes = planes_apart(tile, 3);
    for (const DeformationRequest& request :
         {DeformationRequest{.rotate_degrees = 30}, DeformationRequest{.rotate_degrees = 20, .stretch_x = 4},
          DeformationRequest{.stretch_x = 0.5, .stretch_y = 1, .turbulence_texels = 4, .turbulence_cell = 256}}) {
      Window window = deformed_window({64, 64}, -500, 300, {40, 40}, request);
      window.step_256 = 4 * 256;
      const Image<V3f> truth = supersampled_rows(planes, planes.base, window, 16, 0, 40);
      const auto error_of = [&](Filter filter) {
        window.filter = filter;
        return picture_difference(render(planes, window), truth);
      };
      const double bilinear = error_of(Filter::bilinear).mean;
      for (const Filter filter : {Filter::trilinear, Filter::anisotropic}) {
        // Random texels of deviation 1.15: their means over a pixel keep a quarter of it, points all. Trilinear pixels
        // are as wide as their longer axis.
        const PictureDifference found = error_of(filter);
        EXPECT_LT(found.mean, bilinear / (filter == Filter::trilinear ? 1.5 : 3)) << enum_name(filter);
        // The root of a mean is more than the mean of the roots of white texels, and the noises have a mean.
        EXPECT_LT(std::abs(found.bias), 0.02) << enum_name(filter);
      }
    }
  }
}

TEST(Deform, MapsInManySamplesAreNotDeformed) {
  const SmallTile tile = random_tile({40, 24}, 5, Contents::turned, 69);
  const Image<float> ramp = [] {
    Image<float> image(40, 24);
    for (size_t i = 0; i < image.size(); ++i) image.data()[i] = static_cast<float>(i % 7);
    return image;
  }();
  EvaluatorInput input = tile.input();
  input.maps.push_back({"roughness", MapKind::plain, {ramp}});
  const EvaluatorPlanes planes = prepare(input);
  const Window plain = deformed_window({40, 24}, -50, 9, {16, 16}, {});
  const Window turned = deformed_window({40, 24}, -50, 9, {16, 16}, {.rotate_degrees = 40});
  EXPECT_TRUE(supersampled_rows(planes, planes.maps.front(), turned, 2, 0, 16) ==
              supersampled_rows(planes, planes.maps.front(), plain, 2, 0, 16));
}

TEST(Deform, FiltersDoNotPopWhereADeformationOrAStepBegins) {
  SmallTile tile = tile_with_noise(68);
  const EvaluatorPlanes planes = planes_apart(tile, 3);
  EvaluatorInput plain_input = tile.input();
  plain_input.soft_border_px = 3;
  const EvaluatorPlanes plain = prepare(plain_input);
  Window window = deformed_window({40, 24}, 5, 7, {64, 64}, {});
  window.filter = Filter::trilinear;
  const Image<V3f> undeformed = render(plain, window);
  window.deformation = deformation_of({.stretch_x = 1.0001, .stretch_y = 1.0001});
  // 64 texels by a ten-thousandth and a rounding: 2/256 texel, of texels up to 4 apart.
  for (const uint32_t step : {256u, 257u}) {
    window.step_256 = step;
    if (step == 257) window.width = window.height = 8;
    const Image<V3f> found = render(planes, window);
    for (int y = 0; y < window.height; ++y)
      for (int x = 0; x < window.width; ++x) EXPECT_LT((found(x, y) - undeformed(x, y)).length(), 0.5f);
  }
}

TEST(Deform, AFootprintIsThatOfTheMatrix) {
  const auto footprint = [](const DeformationRequest& request, double texels, int most) {
    return footprint_of(deformation_of(request), texels, most, 9);
  };
  const DeformedFootprint turned = footprint({.rotate_degrees = 30}, 4, 4);
  EXPECT_EQ(turned.level_256, 512);
  EXPECT_EQ(turned.halvings, 0);
  // Stretched four times along x, the structure is seen as through pixels of a quarter of their width.
  const DeformedFootprint stretched = footprint({.stretch_x = 4}, 8, 4);
  EXPECT_EQ(stretched.level_256, 256);
  EXPECT_EQ(stretched.halvings, 2);
  EXPECT_EQ(std::abs(stretched.axis_256[0]), 0);
  EXPECT_EQ(std::abs(stretched.axis_256[1]), 8 * 256);
  const DeformedFootprint blurred = footprint({.stretch_x = 4}, 8, 0);
  EXPECT_EQ(blurred.level_256, 3 * 256);
  EXPECT_EQ(blurred.halvings, 0);
  // Pixels smaller than texels see a texel.
  EXPECT_EQ(footprint({.stretch_x = 0.5, .stretch_y = 0.5}, 0.1, 0).level_256, 256);
  EXPECT_EQ(footprint({.stretch_x = 64, .stretch_y = 64}, 0.1, 4).level_256, 0);
}

TEST(Deform, PositionsAreTheProductRoundedDownWhereverTheAnchorLies) {
  Random random(61);
  const V2i n(1000, 48);
  const SmallTile tile = random_tile({40, 24}, 1, Contents::moved, 61);
  const EvaluatorPlanes planes = tile.planes();
  for (int round = 0; round < 2000; ++round) {
    Deformation deformation;
    for (int32_t& m : deformation.matrix) m = static_cast<int32_t>(random.below(1u << 18)) - (1 << 17);
    const auto coordinate = [&] { return static_cast<int64_t>(random.below(1u << 30)) - (1 << 29); };
    const int64_t from[2] = {coordinate(), coordinate()};
    const auto near = [&] { return static_cast<int64_t>(random.below(1u << 23)) - (1 << 22); };
    const int64_t at[2] = {from[0] + near(), from[1] + near()};

    glsl::Program program = program_of(planes, 1u);
    program.tile_size = {n.x, n.y};
    const TileOffset from_x = tile_offset(from[0], 0, n.x), from_y = tile_offset(from[1], 0, n.y);
    const V2i from_texel(static_cast<int>(from_x.offset_256 >> 8), static_cast<int>(from_y.offset_256 >> 8));
    const DeformationAnchor to = anchor_of(deformation, n, {from_x.tile, from_y.tile}, from_texel);
    program.deform_matrix = {deformation.matrix[0], deformation.matrix[1], deformation.matrix[2],
                             deformation.matrix[3]};
    program.deform_from_tile = {from_x.tile, from_y.tile};
    program.deform_from = {from_texel.x, from_texel.y};
    program.deform_to_tile = {to.tile[0], to.tile[1]};
    program.deform_to = {to.texel[0], to.texel[1], to.fraction_65536[0], to.fraction_65536[1]};
    const TileOffset x = tile_offset(at[0], 0, n.x), y = tile_offset(at[1], 0, n.y);
    const int part[2] = {round % 2 == 0 ? 128 : static_cast<int>(random.below(256)),
                         round % 2 == 0 ? 128 : static_cast<int>(random.below(256))};
    const glsl::Position found = program.deformed_position(
        {{x.tile, y.tile}, {static_cast<int>(x.offset_256) + part[0], static_cast<int>(y.offset_256) + part[1]}});

    // The matrix times the texel's center in 1/65536, and what is left to the point; then down to 1/256.
    const auto expected = [&](int row) {
      const int64_t a = deformation.matrix[2 * row], b = deformation.matrix[2 * row + 1];
      const int64_t rest = (a * (part[0] - 128) + b * (part[1] - 128)) >> 8;
      return (a * at[0] + b * at[1] + ((a + b) >> 1) + rest) >> 8;
    };
    const TileOffset expected_x = tile_offset(0, expected(0), n.x), expected_y = tile_offset(0, expected(1), n.y);
    EXPECT_EQ(found.tile.x, expected_x.tile);
    EXPECT_EQ(found.tile.y, expected_y.tile);
    EXPECT_EQ(static_cast<uint32_t>(found.offset.x), expected_x.offset_256);
    EXPECT_EQ(static_cast<uint32_t>(found.offset.y), expected_y.offset_256);
  }
}

TEST(Deform, WindowsOfOnePictureFitTogether) {
  const SmallTile tile = tile_with_noise(62);
  const EvaluatorPlanes planes = tile.planes();
  const DeformationRequest request{.rotate_degrees = 33, .stretch_x = 1.7, .stretch_y = 0.6, .turbulence_texels = 9};
  const Image<V3f> whole = render(planes, deformed_window({40, 24}, -9000, 400, {90, 60}, request));
  const Image<V3f> part = render(planes, deformed_window({40, 24}, -9000 + 31, 400 + 17, {40, 30}, request));
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) EXPECT_EQ(part(x, y), whole(x + 31, y + 17));
}

TEST(Deform, RowsEqualTheReferenceTextPointByPoint) {
  const SmallTile tile = tile_with_noise(63);
  const EvaluatorPlanes apart = planes_apart(tile, 2);
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic})
    for (const uint32_t step : {200u, 900u}) {
      Window window = deformed_window({40, 24}, -77, 1000, {48, 48},
                                      {.rotate_degrees = -70, .stretch_x = 1.5, .turbulence_texels = 5});
      window.step_256 = step;
      window.filter = filter;
      EXPECT_EQ(render(apart, window), color_values(reference_frame(apart, window, apart.base).values));
    }
}

TEST(Deform, AQuarterTurnIsTheTurnedPicture) {
  const SmallTile tile = random_tile({40, 24}, 5, Contents::moved, 64);
  const EvaluatorPlanes planes = tile.planes();
  const Image<V3f> plain = render(planes, deformed_window({40, 24}, 0, -64, {64, 64}, {}));
  const Image<V3f> turned = render(planes, deformed_window({40, 24}, 0, 0, {64, 64}, {.rotate_degrees = 90}));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(turned(x, y), plain(y, 63 - x)) << "from (y, -x - 1)";
}

TEST(Deform, TurbulenceIsBoundedAndSmoothAndAnotherSeedIsAnother) {
  const SmallTile tile = random_tile({40, 24}, 1, Contents::moved, 65);
  const EvaluatorPlanes planes = tile.planes();
  const Window window =
      deformed_window({40, 24}, -500, -500, {1, 1}, {.turbulence_texels = 20, .turbulence_cell = 128});
  glsl::Program program = program_of(planes, window), other = program;
  other.seed = 6;
  const auto texel = [](int x, int y) {
    return glsl::Position{{static_cast<uint32_t>(x / 40 - 7), static_cast<uint32_t>(y / 24 - 3)},
                          {x % 40 * 256 + 128, y % 24 * 256 + 128}};
  };
  // Octaves of A, A/2, A/4; the slope of t² (3 − 2 t) is 1.5 at most, of each octave 1.5 · 2 A / cell, and three
  // roundings.
  const int bound = 20 * 256 * 7 / 4, slope = 3 * 3 * 20 * 256 / 128 + 3;
  int farthest = 0, differing = 0;
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 500; ++x) {
      const glsl::ivec2 here = program.turbulence_at(texel(x, y)), right = program.turbulence_at(texel(x + 1, y));
      farthest = std::max({farthest, std::abs(here.x), std::abs(here.y)});
      EXPECT_LE(std::abs(here.x - right.x), slope);
      EXPECT_LE(std::abs(here.y - right.y), slope);
      if (other.turbulence_at(texel(x, y)).x != here.x) ++differing;
    }
  EXPECT_LE(farthest, bound);
  EXPECT_GT(farthest, bound / 3);
  EXPECT_GT(differing, 240000);
}

TEST(Deform, WhatIsOutOfRangeIsRefused) {
  EXPECT_THROW(deformation_of({.stretch_x = 0.4}), Error);
  EXPECT_THROW(deformation_of({.turbulence_texels = 65}), Error);
  EXPECT_THROW(deformation_of({.turbulence_cell = 100}), Error);
  EXPECT_THROW(deformation_of({.rotate_degrees = 400}), Error);
}

}  // namespace
}  // namespace texbake
