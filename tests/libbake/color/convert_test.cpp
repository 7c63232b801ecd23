#include "libbake/color/convert.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/half.h"
#include "libbake/color/luv.h"
#include "tests/libbake/color/points.h"

namespace texbake {
namespace {

// A picture of blobs: class k covers every cell of 8×8 texels whose hash says so; colors vary along the class's line.
Image<V3f> blobs(int size, const std::vector<ColorLine>& lines, float along, float across, uint64_t seed = 1) {
  Random random(seed);
  Image<V3f> image(size, size);
  std::vector<uint32_t> cells(static_cast<size_t>(size / 8 * size / 8));
  for (uint32_t& cell : cells) cell = random.below(static_cast<uint32_t>(lines.size()));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const ColorLine& line = lines[cells[static_cast<size_t>(y / 8 * (size / 8) + x / 8)]];
      const float t = along * normal(random);
      V3f luv;
      for (int c = 0; c < 3; ++c)
        luv[c] =
            line.point[static_cast<size_t>(c)] + t * line.direction[static_cast<size_t>(c)] + across * normal(random);
      image(x, y) = linear_from_luv(luv);
    }
  return image;
}

std::vector<ColorLine> three_hues() {
  return {{{45, 60, 30, 0}, {0.8f, 0.6f, 0, 0}}, {{60, -30, 50, 0}, {0.8f, 0, 0.6f, 0}}, {{50, 0, 0, 0}, {1, 0, 0, 0}}};
}

bool same(const Conversion& a, const Conversion& b) {
  const auto same_class = [](const ColorClass& c, const ColorClass& d) {
    return c.dominant == d.dominant && c.variation == d.variation;
  };
  return std::ranges::equal(a.colors.palette.classes, b.colors.palette.classes, same_class) &&
         a.colors.index == b.colors.index && a.colors.variation == b.colors.variation &&
         a.error.mean_delta_e == b.error.mean_delta_e && a.error.p99_delta_e == b.error.p99_delta_e;
}

TEST(Convert, FindsTheHuesOfAPictureDarkFirst) {
  const Conversion result = convert(blobs(128, three_hues(), 5, 1), {});
  ASSERT_EQ(result.colors.palette.classes.size(), 3u);
  const std::vector<ColorClass>& classes = result.colors.palette.classes;
  const V3f expected[] = {V3f(45, 60, 30), V3f(50, 0, 0), V3f(60, -30, 50)};
  for (size_t k = 0; k < 3; ++k) EXPECT_LT((classes[k].dominant - expected[k]).length(), 0.5f);
  EXPECT_NEAR(result.error.mean_delta_e, std::sqrt(M_PI / 2),
              0.05);  // mean length of a normal vector of two dimensions
  EXPECT_NEAR(result.error.p99_delta_e, std::sqrt(2 * std::log(100.0)), 0.15);
}

TEST(Convert, PaletteIsMeanAndUnitPrincipalAxisWithFixedSign) {
  const Image<V3f> image = blobs(96, three_hues(), 6, 2);
  const Conversion result = convert(image, {}, {.classes = 5});
  const auto& classes = result.colors.palette.classes;
  for (size_t k = 0; k < classes.size(); ++k) {
    double count = 0, sum[3] = {};
    for (size_t i = 0; i < image.size(); ++i) {
      if (result.colors.index.data()[i] != k) continue;
      const V3f luv = luv_from_linear(image.data()[i]);
      for (int c = 0; c < 3; ++c) sum[c] += luv[c];
      ++count;
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(classes[k].dominant[c], sum[c] / count, 1e-4);
    EXPECT_NEAR(classes[k].variation.length(), 1, 1e-6);
    float largest = 0;
    for (int c = 0; c < 3; ++c)
      if (std::fabs(classes[k].variation[c]) > std::fabs(largest)) largest = classes[k].variation[c];
    EXPECT_GT(largest, 0);
    if (k > 0) {
      EXPECT_LE(classes[k - 1].dominant.x, classes[k].dominant.x);
    }
  }
}

TEST(Convert, VariationIsHalfExactAndTheErrorIsWhatIsLost) {
  const Image<V3f> image = blobs(64, three_hues(), 6, 2);
  const Conversion result = convert(image, {});
  std::vector<double> lost;
  double sum = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    const float v = result.colors.variation.data()[i];
    EXPECT_EQ(v, half_exact(v));
    const ColorClass& c = result.colors.palette.classes[result.colors.index.data()[i]];
    lost.push_back((luv_from_linear(image.data()[i]) - c.dominant - c.variation * v).length());
    sum += lost.back();
  }
  std::sort(lost.begin(), lost.end());
  EXPECT_NEAR(result.error.mean_delta_e, sum / 4096, 1e-5);
  EXPECT_NEAR(result.error.p99_delta_e, lost[4055], 1e-4);  // 0.99 · 4096 = 4055.04: 4056 texels do not exceed it
}

TEST(Convert, DecodedPictureIsAsFarAsTheErrorSays) {
  const Image<V3f> image = blobs(64, three_hues(), 5, 1);
  const Conversion result = convert(image, {});
  const Image<V3f> decoded = decode(result.colors);
  double sum = 0;
  for (size_t i = 0; i < image.size(); ++i)
    sum += (luv_from_linear(decoded.data()[i]) - luv_from_linear(image.data()[i])).length();
  EXPECT_NEAR(sum / 4096, result.error.mean_delta_e, 1e-3);
}

TEST(Convert, EquationOneLosesLeastAndCompacterClassesLoseMore) {
  const Image<V3f> image = blobs(96, three_hues(), 12, 3);
  double before = 0;
  for (const float weight : {0.0f, 0.1f, 1.0f}) {
    const double error = convert(image, {}, {.classes = 6, .along_weight = weight}).error.mean_delta_e;
    EXPECT_GT(error, before);
    before = error;
  }
}

TEST(Convert, ConstantPictureIsOneClassWithoutError) {
  const Conversion result = convert(Image<V3f>(16, 16, V3f(0.2f, 0.3f, 0.1f)), {});
  ASSERT_EQ(result.colors.palette.classes.size(), 1u);
  EXPECT_EQ(result.colors.palette.classes[0].dominant, luv_from_linear(V3f(0.2f, 0.3f, 0.1f)));
  EXPECT_EQ(result.colors.palette.classes[0].variation.length(), 1);
  EXPECT_EQ(result.error.p99_delta_e, 0);
  EXPECT_EQ(result.effective.classes, 1);
}

TEST(Convert, OneTexelIsAPicture) {
  EXPECT_EQ(convert(Image<V3f>(1, 1, V3f(0.5f)), {}).colors.palette.classes.size(), 1u);
}

TEST(Convert, GrayPictureIsDividedByLightness) {
  Image<V3f> image(64, 64);
  for (size_t i = 0; i < image.size(); ++i) image.data()[i] = V3f(static_cast<float>(i) / 4096.0f);
  const Conversion result = convert(image, {}, {.classes = 4});
  ASSERT_EQ(result.colors.palette.classes.size(), 4u);
  for (const ColorClass& c : result.colors.palette.classes) EXPECT_NEAR(c.variation.x, 1, 1e-5);
  for (size_t i = 1; i < image.size(); ++i) EXPECT_LE(result.colors.index.data()[i - 1], result.colors.index.data()[i]);
  EXPECT_LT(result.error.p99_delta_e, 0.02);  // half a half-float step of v: 2^-6 for |v| ≥ 16
}

TEST(Convert, MoreClassesThanColorsNamesTheirNumber) {
  Image<V3f> image(8, 8, V3f(0.2f));
  image(3, 3) = V3f(0.4f, 0.1f, 0.1f);
  image(5, 1) = V3f(0.1f, 0.5f, 0.1f);
  EXPECT_EQ(convert(image, {}, {.classes = 3}).colors.palette.classes.size(), 3u);
  try {
    convert(image, {}, {.classes = 4});
    FAIL() << "expected Error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_THAT(error.what(), testing::HasSubstr("expected at most 3"));
    EXPECT_THAT(error.what(), testing::HasSubstr("found 4"));
  }
  EXPECT_THROW(resolve({.classes = 4}, image), Error);
}

TEST(Convert, OptionsOutsideTheirRangeAreRefused) {
  const Image<V3f> image(8, 8, V3f(0.2f));
  EXPECT_THROW(convert(image, {}, {.classes = 0}), Error);
  EXPECT_THROW(convert(image, {}, {.classes = 65}), Error);
  EXPECT_THROW(convert(image, {}, {.along_weight = -1}), Error);
}

TEST(Convert, RareColorInALargePictureGetsItsClass) {
  Image<V3f> image(700, 700, V3f(0.2f, 0.3f, 0.4f));  // more texels than are sampled
  image(123, 456) = V3f(0.8f, 0.1f, 0.1f);
  const Conversion result = convert(image, {}, {.classes = 2});
  ASSERT_EQ(result.colors.palette.classes.size(), 2u);
  EXPECT_NE(result.colors.index(123, 456), result.colors.index(0, 0));
  EXPECT_NEAR(result.error.p99_delta_e, 0, 1e-5);
}

TEST(Convert, EffectiveOptionsGiveTheSameBytes) {
  const Image<V3f> image = blobs(160, three_hues(), 8, 3);
  const Conversion automatic = convert(image, {});
  ASSERT_TRUE(automatic.effective.classes.has_value());
  EXPECT_EQ(resolve({}, image).classes, automatic.effective.classes);
  EXPECT_TRUE(same(convert(image, {}, automatic.effective), automatic));
}

TEST(Convert, ThreadsDoNotChangeTheResult) {
  const Image<V3f> image = blobs(600, three_hues(), 8, 3);  // larger than the samples
  const Conversion many = convert(image, {});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(same(convert(image, {}), many));
}

TEST(Convert, RotatingTheTorusRotatesTheIndex) {
  const Image<V3f> image = blobs(64, three_hues(), 5, 1);
  Image<V3f> rotated(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) rotated(x, y) = image(wrap(x + 23, 64), wrap(y - 11, 64));
  const Conversion before = convert(image, {}), after = convert(rotated, {});
  int different = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      different += after.colors.index(x, y) != before.colors.index(wrap(x + 23, 64), wrap(y - 11, 64));
  EXPECT_EQ(different, 0);  // the classes are far apart; rounding of sums cannot move a texel
}

TEST(Convert, HeightSeparatesTwoClassesOfEqualColor) {
  const Image<V3f> image = blobs(64, {{{50, 10, 20, 0}, {1, 0, 0, 0}}}, 3, 1);
  Image<float> height(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) height(x, y) = (x / 16 + y / 16) % 2 ? 0.9f : 0.1f;
  const Conversion result = convert(image, height, {.classes = 2, .height_weight = 60});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      EXPECT_EQ(result.colors.index(x, y) == result.colors.index(0, 0), height(x, y) == height(0, 0));
  // The stored palette has no height in it: two classes of the same color, with unit directions.
  const auto& classes = result.colors.palette.classes;
  EXPECT_LT((classes[0].dominant - classes[1].dominant).length(), 0.6f);
  for (const ColorClass& c : classes) EXPECT_NEAR(c.variation.length(), 1, 1e-6);
}

TEST(Convert, HeightsMakeEqualColorsDistinct) {
  const Image<V3f> image(8, 8, V3f(0.3f));
  Image<float> height(8, 8);
  height(2, 2) = 1;
  EXPECT_EQ(convert(image, height, {.classes = 2}).colors.palette.classes.size(), 2u);
  EXPECT_THROW(convert(image, {}, {.classes = 2}), Error);
}

TEST(Convert, HeightWithoutWeightChangesNothing) {
  const Image<V3f> image = blobs(64, three_hues(), 5, 1);
  Image<float> height(64, 64);
  for (size_t i = 0; i < height.size(); ++i) height.data()[i] = static_cast<float>(i % 7) / 7;
  const Conversion with = convert(image, height, {.classes = 3, .height_weight = 0});
  EXPECT_EQ(with.colors.index, convert(image, {}, {.classes = 3}).colors.index);
}

TEST(Convert, ProgressGrowsToOne) {
  std::vector<double> seen;
  convert(blobs(32, three_hues(), 5, 1), {}, {}, [&](double done) { seen.push_back(done); });
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1);
}

}  // namespace
}  // namespace texbake
