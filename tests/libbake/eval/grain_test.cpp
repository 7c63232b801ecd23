// The laws of structure + noise, seen through the evaluator: what a synthesised noise is as a signal.
// Based on: Guingo et al. 2017, eq. 1-2, Fig. 3 and 10.
#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/half.h"
#include "libbake/eval/window.h"
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

}  // namespace
}  // namespace texbake
