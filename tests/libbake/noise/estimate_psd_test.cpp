#include "libbake/noise/estimate_psd.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/noise/spectrum_difference.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

/// Two colored noises on a flat structure, each in half of the texels.
struct MaskedField {
  explicit MaskedField(int size)
      : exemplar(size, size),
        structure(size, size, V3f(0.5f)),
        ring(synthetic_noise(ring_power, size, 0.004, 1)),
        blob(synthetic_noise(blob_power, size, 0.002, 2)) {
    masks.emplace_back(size, size);
    masks.emplace_back(size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const bool first = x < size / 2;
        masks[first ? 0 : 1](x, y) = 1.0f;
        exemplar(x, y) = V3f(0.5f) + (first ? V3f(0.8f, 0.6f, 0) * ring(x, y) : V3f(0.6f, 0.8f, 0) * blob(x, y));
      }
  }
  Image<V3f> exemplar;
  Image<V3f> structure;
  Image<float> ring;
  Image<float> blob;
  std::vector<Image<float>> masks;
};

EstimatePsdOptions small() {
  EstimatePsdOptions options;
  options.space = NoiseSpace::linear;  // of the known fields
  options.spectrum_size = 32;
  options.lobes = 2;
  options.core_share = 1.0f;
  options.histogram = NoiseHistogram::gaussian;
  return options;
}

TEST(EstimatePsd, FindsSpectraAndColorsOfBothNoises) {
  const MaskedField field(256);
  const NoiseModel model = estimate_psd(field.exemplar, field.structure, field.masks, small());
  ASSERT_EQ(model.noises.size(), 2u);
  EXPECT_GT(model.noises[0].basis.axis[0].dot(V3f(0.8f, 0.6f, 0)), 0.999f);
  EXPECT_GT(model.noises[1].basis.axis[0].dot(V3f(0.6f, 0.8f, 0)), 0.999f);
  // Half of 256² texels: power within 3 % of what the mask holds, the shape as far as so few texels show it.
  EXPECT_LE(power_error(model.noises[0].channels[0].spectrum, true_spectrum(ring_power, 32, 0.004)), 0.25);
  for (const Noise& noise : model.noises)
    EXPECT_NEAR(power_of(noise.channels[0].spectrum) / noise.figures.variance[0], 1.0, 1e-4);
}

TEST(EstimatePsd, TilesHaveTheMeanVarianceAndSpectrumOfTheModel) {
  const MaskedField field(128);
  const NoiseModel model = estimate_psd(field.exemplar, field.structure, field.masks, small());
  for (const Noise& noise : model.noises) {
    Image<float> channel(noise.tile.width(), noise.tile.height());
    V3f sum(0);
    for (size_t i = 0; i < channel.size(); ++i) {
      EXPECT_EQ(half_exact(noise.tile.data()[i]), noise.tile.data()[i]);
      channel.data()[i] = noise.basis.channels(noise.tile.data()[i]).x;
      sum += noise.tile.data()[i] / static_cast<float>(channel.size());
    }
    EXPECT_NEAR((sum - noise.basis.mean).length(), 0.0f, 1e-5f);
    EXPECT_NEAR(variance_of(channel) / power_of(noise.channels[0].spectrum), 1.0, 1e-3);  // half precision
    EXPECT_LE(noise.figures.tile_difference_db, 1.0);
  }
}

TEST(EstimatePsd, EqualizationKeepsVarianceAndGivesTheHistogram) {
  // A noise of two values only, as far from Gaussian as can be.
  MaskedField field(128);
  for (size_t i = 0; i < field.exemplar.size(); ++i)
    field.exemplar.data()[i] = V3f(0.5f) + V3f(field.ring.data()[i] > 0.0f ? 0.125f : -0.125f);
  EstimatePsdOptions options = small();
  options.histogram = NoiseHistogram::exemplar;
  const NoiseModel model = estimate_psd(field.exemplar, field.structure, field.masks, options);
  const Noise& noise = model.noises[0];
  int two_valued = 0;
  for (const V3f& color : noise.tile) two_valued += std::abs(std::abs(color.x) - 0.125f) < 0.01f ? 1 : 0;
  EXPECT_GT(two_valued / double(noise.tile.size()), 0.98);
  EXPECT_NEAR(noise.figures.tile_variance_ratio, 1.0, 0.03);
}

TEST(EstimatePsd, AMaskWithoutNoiseGivesNone) {
  MaskedField field(64);
  for (int y = 0; y < 64; ++y)
    for (int x = 32; x < 64; ++x) field.exemplar(x, y) = field.structure(x, y);
  const NoiseModel model = estimate_psd(field.exemplar, field.structure, field.masks, small());
  EXPECT_EQ(power_of(model.noises[1].channels[0].spectrum), 0.0);
  for (const V3f& color : model.noises[1].tile) EXPECT_EQ(color, V3f(0));
}

TEST(EstimatePsd, FallsBackToASmallerTableAndSaysSo) {
  const MaskedField field(64);
  EstimatePsdOptions options = small();
  options.spectrum_size = 64;
  const NoiseModel model = estimate_psd(field.exemplar, field.structure, field.masks, options);
  EXPECT_EQ(model.noises[0].spectrum_size(), 16);  // 2048 texels: 4 · 16² fit, 4 · 32² do not
  ASSERT_EQ(model.warnings.size(), 2u);
  EXPECT_NE(model.warnings[0].find("2048 texels"), std::string::npos) << model.warnings[0];
}

TEST(EstimatePsd, SynthesisFollowsTheMasks) {
  const MaskedField field(64);
  const NoiseModel model = estimate_psd(field.exemplar, field.structure, field.masks, small());
  const Image<V3f> noise = synthesise_noise(model, field.masks);
  EXPECT_EQ(noise(3, 0), model.noises[0].tile(3, 0));
  EXPECT_EQ(noise(40, 5), model.noises[1].tile.data()[(40 + 5 * 111111) % (512 * 512)]);
}

TEST(EstimatePsd, InTheRootItFindsWhatItFindsInLight) {
  // The square root of a square is exact, and so the two are one problem.
  const MaskedField field(64);
  EstimatePsdOptions options = small();
  const NoiseModel in_light = estimate_psd(field.exemplar, field.structure, field.masks, options);
  options.space = NoiseSpace::root;
  const Image<V3f> exemplar = to_light(field.exemplar, NoiseSpace::root);
  const Image<V3f> structure = to_light(field.structure, NoiseSpace::root);
  const NoiseModel in_root = estimate_psd(exemplar, structure, field.masks, options);
  EXPECT_EQ(in_root.space, NoiseSpace::root);
  for (size_t k = 0; k < 2; ++k) EXPECT_TRUE(in_root.noises[k].tile == in_light.noises[k].tile);
  const Image<V3f> again = synthesise(structure, in_root, field.masks);
  EXPECT_NEAR(again(3, 0).x, std::pow(0.5f + in_root.noises[0].tile(3, 0).x, 2.0f), 1e-6f);
}

TEST(EstimatePsd, DoesNotDependOnThreads) {
  const MaskedField field(64);
  EstimatePsdOptions options = small();
  options.core_share = 0.9f;
  const NoiseModel many = estimate_psd(field.exemplar, field.structure, field.masks, options);
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const NoiseModel single = estimate_psd(field.exemplar, field.structure, field.masks, options);
  for (size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(many.noises[k].tile == single.noises[k].tile);
    EXPECT_TRUE(many.noises[k].channels[0].spectrum == single.noises[k].channels[0].spectrum);
    EXPECT_EQ(many.noises[k].channels[0].lobes.error, single.noises[k].channels[0].lobes.error);
  }
}

TEST(EstimatePsd, RefusesWhatDoesNotFit) {
  MaskedField field(64);
  EstimatePsdOptions options = small();
  options.spectrum_size = 48;
  EXPECT_THROW(estimate_psd(field.exemplar, field.structure, field.masks, options), Error);
  EXPECT_THROW(estimate_psd(field.exemplar, Image<V3f>(32, 32), field.masks, small()), Error);
  field.masks[0](0, 0) = 0.0f;  // a texel without weight
  EXPECT_THROW(estimate_psd(field.exemplar, field.structure, field.masks, small()), Error);
}

}  // namespace
}  // namespace texbake
