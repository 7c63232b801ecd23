#include "libbake/noise/masks.h"

#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

TEST(QuantizeWeights, SumToOneByTheLargestRemainder) {
  const double thirds[] = {1.0, 1.0, 1.0};
  float quantized[3];
  quantize_weights(thirds, quantized);
  // 2048 / 3 = 682 and 2/3: two of three equal remainders are rounded up, the first ones.
  EXPECT_EQ(quantized[0], 683.0f / 2048);
  EXPECT_EQ(quantized[1], 683.0f / 2048);
  EXPECT_EQ(quantized[2], 682.0f / 2048);
}

TEST(QuantizeWeights, KeepsWhatIsExact) {
  const double weights[] = {3.0, 0.0, 1.0};
  float quantized[3];
  quantize_weights(weights, quantized);
  EXPECT_EQ(quantized[0], 0.75f);
  EXPECT_EQ(quantized[1], 0.0f);
  EXPECT_EQ(quantized[2], 0.25f);
}

/// A field of two grains of the same brightness, ring noise in the middle, and its features.
struct TwoGrains {
  explicit TwoGrains(int size) : image(size, size), inside(size, size) {
    const Image<float> ring = synthetic_noise(ring_power, size, 0.004, 1);
    const Image<float> blob = synthetic_noise(blob_power, size, 0.004, 2);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        inside(x, y) = abs(x - size / 2) < size / 4 ? 1 : 0;
        image(x, y) = V3f(0.5f + (inside(x, y) ? ring(x, y) : blob(x, y)));
      }
    light = luminance(image);
  }
  Image<V3f> image;
  Image<uint8_t> inside;
  Image<float> light;
};

TEST(Masks, AreConvexAndQuantized) {
  const TwoGrains field(64);
  const LocalSpectra spectra(field.light, 4);
  const GrainFeatures features(field.image, spectra, 1.0);
  for (const int noises : {2, 3, 4})
    for (const MaskKind kind : {MaskKind::binary, MaskKind::soft})
      EXPECT_NO_THROW(check_masks(assign_masks(features, cluster_grain(features, noises, 1), kind)));
}

TEST(Masks, SoftOnesLeanWhereBinaryOnesFall) {
  const TwoGrains field(64);
  const LocalSpectra spectra(field.light, 8);
  const GrainFeatures features(field.image, spectra, 1.0);
  const Vectors centers = cluster_grain(features, 2, 1);
  const auto binary = assign_masks(features, centers, MaskKind::binary);
  const auto soft = assign_masks(features, centers, MaskKind::soft);
  // Binary borders lie at 0.35 … 0.65 of the way between the centers, where 1/d² gives weights of 0.22 … 0.78.
  for (size_t i = 0; i < field.image.size(); ++i) {
    if (soft[0].data()[i] > 0.78f) {
      EXPECT_EQ(binary[0].data()[i], 1.0f);
    }
    if (soft[0].data()[i] < 0.22f) {
      EXPECT_EQ(binary[0].data()[i], 0.0f);
    }
  }
}

TEST(Masks, ABorderLiesWhereBothNoisesHaveHalfOfThePower) {
  // White grain of two strengths, side by side, without color to help: the weak side must not lose texels to the
  // strong one, whose power leaks into its windows.
  const Image<float> grain = white_noise(128, 3);
  Image<V3f> image(128, 128);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) image(x, y) = V3f(0.5f + grain(x, y) * (x < 64 ? 0.01f : 0.1f));
  const Image<float> light = luminance(image);
  const LocalSpectra spectra(light, 8);
  const GrainFeatures features(image, spectra, 0.0);
  const auto masks = assign_masks(features, cluster_grain(features, 2, 1), MaskKind::binary);
  double weak = 0.0;
  for (size_t i = 0; i < image.size(); ++i) weak += double(masks[masks[0](32, 64) > 0.5f ? 0 : 1].data()[i]);
  // Two borders of 128 texels: the nearest center misses by 5 texels on each, this by less than 4.
  EXPECT_GT(weak, 128 * (64 - 8));
}

TEST(Masks, AreNotFooledByBrightness) {
  // One grain, two levels: spectra are alike but for frequency 0. With little weight on color, the masks follow the
  // grain of a second pair of regions instead.
  TwoGrains field(128);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x)
      if (y >= 64) field.image(x, y) += V3f(0.05f);
  field.light = luminance(field.image);
  const LocalSpectra spectra(field.light, 8);
  const GrainFeatures features(field.image, spectra, 0.0);
  const auto masks = assign_masks(features, cluster_grain(features, 2, 1), MaskKind::binary);
  int right = 0;
  for (size_t i = 0; i < field.image.size(); ++i)
    right += (masks[0].data()[i] > 0.5f) == (field.inside.data()[i] == 1) ? 1 : 0;
  EXPECT_GT(std::max(right, 128 * 128 - right), 128 * 128 * 85 / 100);
}

TEST(ClusterCores, HoldTheShareOfEachCluster) {
  const TwoGrains field(64);
  const LocalSpectra spectra(field.light, 4);
  const GrainFeatures features(field.image, spectra, 1.0);
  const auto masks = assign_masks(features, cluster_grain(features, 2, 1), MaskKind::binary);
  const auto cores = cluster_cores(features, masks, 0.9);
  for (size_t k = 0; k < 2; ++k) {
    int64_t of_mask = 0;
    int64_t of_core = 0;
    for (size_t i = 0; i < masks[k].size(); ++i) {
      of_mask += masks[k].data()[i] > 0.5f ? 1 : 0;
      of_core += cores[k].data()[i];
      EXPECT_LE(float(cores[k].data()[i]), masks[k].data()[i]);
    }
    EXPECT_NEAR(double(of_core), 0.9 * double(of_mask), 2.0);
  }
}

TEST(CheckMasks, NameTheTexelThatIsWrong) {
  std::vector<Image<float>> masks;
  masks.emplace_back(4, 3, 1.0f);
  masks.emplace_back(4, 3, 0.0f);
  EXPECT_NO_THROW(check_masks(masks));
  masks[0](2, 1) = 0.5f;
  try {
    check_masks(masks);
    FAIL() << "a texel has half a weight";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_NE(std::string(error.what()).find("(2, 1)"), std::string::npos) << error.what();
  }
  masks[1](2, 1) = 0.4999f;
  EXPECT_THROW(check_masks(masks), Error);
}

}  // namespace
}  // namespace texbake
