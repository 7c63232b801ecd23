// The laws of structure + noise, seen through the evaluator: what a synthesised noise is as a signal.
// Based on: Guingo et al. 2017, eq. 1-2, Fig. 3 and 10.
#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/half.h"
#include "libbake/eval/levels.h"
#include "libbake/eval/window.h"
#include "libbake/noise/lobes.h"
#include "libbake/noise/noise_tile.h"
#include "libbake/noise/spectrum.h"
#include "libbake/noise/spectrum_difference.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

constexpr int kSide = 256;  // of the tile and of the noises
constexpr double kVariance = 0.01;

/// A grey realisation, half-exact, about `mean`.
Image<V3f> realised(const PowerLaw& law, double variance, float mean) {
  const Image<float> plane = realise_noise(true_spectrum(law, kSide, variance), random_phases(kSide, 3, 0));
  Image<V3f> tile(kSide, kSide);
  for (size_t i = 0; i < tile.size(); ++i) tile.data()[i] = half_exact(V3f(plane.data()[i] + mean));
  return tile;
}

/// One period of the noise under a constant structure.
Image<float> seen(const Image<V3f>& base, const std::vector<Image<float>>& masks, const std::vector<Image<V3f>>& tiles,
                  const DeformationRequest& request = {}) {
  EvaluatorInput input;
  input.base = base;
  if (!tiles.empty()) input.noise = NoiseInput{{masks.begin(), masks.end()}, {tiles.begin(), tiles.end()}};
  const EvaluatorPlanes planes = prepare(input);
  Window window;
  window.width = window.height = kSide;
  window.deformation = deformation_of(request);
  const Image<V3f> picture = render_rows(planes, window, 0, kSide);
  Image<float> channel(kSide, kSide);
  for (size_t i = 0; i < channel.size(); ++i) channel.data()[i] = picture.data()[i].y;
  return channel;
}

double mean_of(const Image<float>& image) {
  double sum = 0;
  for (const float value : image) sum += static_cast<double>(value);
  return sum / static_cast<double>(image.size());
}

std::vector<Image<float>> masks_of(std::initializer_list<float> weights) {
  std::vector<Image<float>> masks;
  for (const float weight : weights) masks.emplace_back(kSide, kSide, weight);
  return masks;
}

const Image<V3f>& grey() {
  static const Image<V3f> base(kSide, kSide, V3f(0.5f));
  return base;
}

// 2^-11 of values below 1 is a half float's rounding: 3e-4 of the deviation 0.1 at most, far below these tolerances.
TEST(Grain, HasTheMeanTheVarianceAndTheSpectrumOfItsModel) {
  std::vector<Image<V3f>> tiles;
  tiles.push_back(realised(ring_power, kVariance, 0.125f));
  const Image<float> picture = seen(grey(), masks_of({1}), tiles);
  EXPECT_NEAR(mean_of(picture), 0.625, 1e-4);
  EXPECT_NEAR(variance_of(picture), kVariance, 1e-4 * kVariance + 1e-6);
  EXPECT_LE(spectrum_difference_db(periodogram(picture), true_spectrum(ring_power, kSide, kVariance)), 1.0);
}

TEST(Grain, AnEvenBlendOfTwoKeepsTheirMeanDeviation) {
  std::vector<Image<V3f>> tiles;
  tiles.push_back(realised(ring_power, kVariance, 0));
  tiles.push_back(realised(blob_power, 4 * kVariance, 0));
  const Image<float> picture = seen(grey(), masks_of({0.5f, 0.5f}), tiles);
  // Shared phases add magnitudes: the blended spectrum is the mean of the two.
  const Image<float> one = true_spectrum(ring_power, kSide, kVariance);
  Image<float> blended = true_spectrum(blob_power, kSide, 4 * kVariance);
  for (size_t i = 0; i < blended.size(); ++i) blended.data()[i] = 0.5f * (blended.data()[i] + one.data()[i]);
  EXPECT_NEAR(variance_of(picture) / power_of(blended), 1.0, 1e-3);
  EXPECT_LE(spectrum_difference_db(periodogram(picture), blended), 1.0);
}

TEST(Grain, KeepsItsSpectrumWhereASingleLayersShifts) {
  const DeformationRequest requests[] = {
      {.rotate_degrees = 30}, {.stretch_x = 2, .stretch_y = 2}, {.stretch_x = 2.5}, {.turbulence_texels = 12}};
  std::vector<Image<V3f>> tiles;
  const PowerLaw streaks = [](double fx, double fy) { return ring_power(2 * fx, 0.5 * fy); };
  tiles.push_back(realised(streaks, kVariance, 0));
  const Image<float> model = true_spectrum(streaks, kSide, kVariance);
  Image<V3f> single = tiles[0].clone();
  for (V3f& color : single) color = half_exact(color + V3f(0.5f));
  for (const DeformationRequest& request : requests) {
    EXPECT_LE(spectrum_difference_db(periodogram(seen(grey(), masks_of({1}), tiles, request)), model), 1.0);
    EXPECT_GE(spectrum_difference_db(periodogram(seen(single, {}, {}, request)), model), 3.0);
  }
}

/// The mean over 2^level texels: what is left of a frequency.
double box_transfer(double f_cpp, int level) {
  double transfer = 1;
  for (int j = 0; j < level; ++j) transfer *= std::cos(M_PI * f_cpp * (1 << j));
  return transfer;
}

/// What blocks of 2^level texels show of a spectrum: it fades, and what such blocks cannot carry turns into the
/// frequencies that they can.
Image<float> block_spectrum(const Image<float>& spectrum, int level) {
  const int size = spectrum.width(), blocks = size >> level;
  Image<double> power(blocks, blocks);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto left = static_cast<double>(spectrum(x, y)) * box_transfer(shortest(x, size) / double{kSide}, level) *
                        box_transfer(shortest(y, size) / double{kSide}, level);
      power(x % blocks, y % blocks) += left * left;
    }
  Image<float> faded(blocks, blocks);
  for (size_t i = 0; i < faded.size(); ++i) faded.data()[i] = static_cast<float>(std::sqrt(power.data()[i]));
  return faded;
}

Image<float> seen_in_blocks(const std::vector<Image<V3f>>& tiles, int level) {
  EvaluatorInput input;
  const std::vector<Image<float>> masks = masks_of({1});
  input.base = grey();
  input.noise = NoiseInput{{masks.begin(), masks.end()}, {tiles.begin(), tiles.end()}};
  EvaluatorPlanes planes = prepare(input);
  add_levels(planes);
  Window window;
  window.width = window.height = kSide >> level;
  window.step_256 = 256u << level;
  window.filter = Filter::trilinear;
  const Image<V3f> picture = render_rows(planes, window, 0, window.height);
  Image<float> channel(window.width, window.height);
  for (size_t i = 0; i < channel.size(); ++i) channel.data()[i] = picture.data()[i].y;
  return channel;
}

TEST(Grain, FadesWithTheLevelAsTheFootprintFadesItsLobes) {
  // Coarse grain, a ripple, and fine grain; deviations of 0.02 cycles per texel.
  const Lobe lobes[] = {{0.004, 0.02, 0.0, 50, 0, 50}, {0.004, 0.06, 0.03, 50, 0, 50}, {0.002, 0.2, -0.1, 50, 0, 50}};
  const Image<float> model = lobe_spectrum(lobes, kSide);
  std::vector<Image<V3f>> tiles;
  const Image<float> plane = realise_noise(model, random_phases(kSide, 3, 0));
  tiles.emplace_back(kSide, kSide);
  for (size_t i = 0; i < plane.size(); ++i) tiles[0].data()[i] = half_exact(V3f(plane.data()[i] + 0.125f));
  for (int level = 1; level <= 3; ++level) {  // 32 × 32 blocks: enough frequencies to compare
    const Image<float> picture = seen_in_blocks(tiles, level);
    EXPECT_NEAR(mean_of(picture), 0.625, 1e-4) << level;
    // Frequencies that fold onto one another interfere: their sum is right in the mean over the phases alone.
    const Image<float> blocks = block_spectrum(model, level);
    EXPECT_NEAR(variance_of(picture) / power_of(blocks), 1.0, 0.03) << level;
    EXPECT_LE(spectrum_difference_db(periodogram(picture), blocks), 1.0) << level;
    // The closed form is that of a Gaussian footprint as wide as the block, whose transfer has no second lobe: 5 % of
    // the whole variance.
    const double width = (std::pow(4.0, level) - 1) / 12;
    EXPECT_NEAR(variance_of(picture), filtered_variance(lobes, width, 0, width), 0.05 * 0.01) << level;
  }
}

}  // namespace
}  // namespace texbake
