// The laws of structure + noise, seen through the evaluator: what a synthesized noise is as a signal.
// Based on: Guingo et al. 2017, eq. 1-2, Fig. 3 and 10.
#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/half.h"
#include "libbake/draw/window_rows.h"
#include "libbake/noise/lobes.h"
#include "libbake/noise/noise_tile.h"
#include "libbake/noise/spectrum.h"
#include "libbake/noise/spectrum_difference.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

constexpr int kSide = 256;  // of the tile
constexpr double kVariance = 0.01;
constexpr NoiseLattice kLattice{256 * 256, 23539};

/// A gray realization, half-exact, about `mean`.
Image<V3f> realised(const Image<float>& spectrum, float mean) {
  const Image<float> values = realise_noise(spectrum, random_phases(kLattice.count, 3, 0));
  Image<V3f> tile(kSide, kLattice.count / kSide);
  for (size_t i = 0; i < tile.size(); ++i) tile.data()[i] = half_exact(V3f(values.data()[i] + mean));
  return tile;
}

EvaluatorPlanes planes_of(const Image<V3f>& base, const std::vector<Image<float>>& masks,
                          const std::vector<Image<V3f>>& tiles) {
  EvaluatorInput input;
  input.base = base;
  if (!tiles.empty())
    input.noise =
        NoiseInput{{masks.begin(), masks.end()}, {tiles.begin(), tiles.end()}, kLattice.row_step, NoiseSpace::linear};
  return prepare(input);
}

/// A window under a constant structure.
Image<float> seen(const EvaluatorPlanes& planes, V2i size, const DeformationRequest& request = {}) {
  Window window;
  window.width = size.x;
  window.height = size.y;
  window.deformation = deformation_of(request);
  const Image<V3f> picture = render_rows(planes, window, 0, size.y);
  Image<float> channel(size.x, size.y);
  for (size_t i = 0; i < channel.size(); ++i) channel.data()[i] = picture.data()[i].y;
  return channel;
}

/// All values of the noise: a row as long as they last.
Image<float> all_seen(const EvaluatorPlanes& planes) { return seen(planes, {kLattice.count, 1}); }

/// The spectrum that a window of the plane shows.
Image<float> plane_spectrum(const EvaluatorPlanes& planes, const DeformationRequest& request = {}) {
  return periodogram(windowed(seen(planes, {kSide, kSide}, request)));
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

const Image<V3f>& gray() {
  static const Image<V3f> base(kSide, kSide, V3f(0.5f));
  return base;
}

// 2^-11 of values below 1 is a half float's rounding: 3e-4 of the deviation 0.1 at most, far below these tolerances.
TEST(Grain, HasTheMeanTheVarianceAndTheSpectrumOfItsModel) {
  std::vector<Image<V3f>> tiles;
  tiles.push_back(realised(true_spectrum(ring_power, kLattice, kVariance), 0.125f));
  const EvaluatorPlanes planes = planes_of(gray(), masks_of({1}), tiles);
  const Image<float> values = all_seen(planes);
  EXPECT_NEAR(mean_of(values), 0.625, 1e-4);
  EXPECT_NEAR(variance_of(values), kVariance, 1e-4 * kVariance + 1e-6);
  EXPECT_LE(spectrum_difference_db(periodogram(values), true_spectrum(ring_power, kLattice, kVariance), kLattice), 0.1);
  // The few hundred frequencies of a bin that a window sees differ by chance: 0.5 dB.
  EXPECT_LE(spectrum_difference_db(plane_spectrum(planes), true_spectrum(ring_power, kSide, kVariance)), 1.0);
}

TEST(Grain, AnEvenBlendOfTwoKeepsTheirMeanDeviation) {
  const Image<float> one = true_spectrum(ring_power, kLattice, kVariance);
  Image<float> blended = true_spectrum(blob_power, kLattice, 4 * kVariance);
  std::vector<Image<V3f>> tiles;
  tiles.push_back(realised(one, 0));
  tiles.push_back(realised(blended, 0));
  const Image<float> values = all_seen(planes_of(gray(), masks_of({0.5f, 0.5f}), tiles));
  // Shared phases add magnitudes: the blended spectrum is the mean of the two.
  for (size_t i = 0; i < blended.size(); ++i) blended.data()[i] = 0.5f * (blended.data()[i] + one.data()[i]);
  EXPECT_NEAR(variance_of(values) / power_of(blended), 1.0, 1e-3);
  EXPECT_LE(spectrum_difference_db(periodogram(values), blended, kLattice), 0.1);
}

TEST(Grain, KeepsItsSpectrumWhereASingleLayersShifts) {
  const DeformationRequest requests[] = {
      {.rotate_degrees = 30}, {.stretch_x = 2, .stretch_y = 2}, {.stretch_x = 2.5}, {.turbulence_texels = 12}};
  const PowerLaw streaks = [](double fx, double fy) { return ring_power(2 * fx, 0.5 * fy); };
  std::vector<Image<V3f>> tiles;
  tiles.push_back(realised(true_spectrum(streaks, kLattice, kVariance), 0));
  const EvaluatorPlanes two_layers = planes_of(gray(), masks_of({1}), tiles);
  const Image<float> undeformed = seen(two_layers, {kSide, kSide});
  const Image<float> model = true_spectrum(streaks, kSide, kVariance);
  const Image<float> grain = synthetic_noise(streaks, kSide, kVariance, 3);
  Image<V3f> single(kSide, kSide);
  for (size_t i = 0; i < single.size(); ++i) single.data()[i] = half_exact(V3f(0.5f + grain.data()[i]));
  const EvaluatorPlanes one_layer = planes_of(single, {}, {});
  for (const DeformationRequest& request : requests) {
    EXPECT_TRUE(seen(two_layers, {kSide, kSide}, request) == undeformed)
        << "above a structure that is the same anywhere";
    EXPECT_GE(spectrum_difference_db(plane_spectrum(one_layer, request), model), 3.0);
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
  const int blocks = kLattice.count >> level;
  std::vector<double> power(static_cast<size_t>(blocks));
  for (int k = 0; k < kLattice.count; ++k) {
    const Imath::V2d f = kLattice.frequency(k);
    const double left = double(spectrum(k, 0)) * box_transfer(f.x, level) * box_transfer(f.y, level);
    power[static_cast<size_t>(k % blocks)] += left * left;
  }
  Image<float> faded(blocks, 1);
  for (size_t i = 0; i < faded.size(); ++i) faded.data()[i] = static_cast<float>(std::sqrt(power[i]));
  return faded;
}

/// All values of a level, in a row.
Image<float> all_blocks(const EvaluatorPlanes& planes, int level) {
  Window window;
  window.width = kLattice.count >> level;
  window.height = 1;
  window.step_256 = 256u << level;
  window.filter = Filter::trilinear;
  const Image<V3f> picture = render_rows(planes, window, 0, 1);
  Image<float> channel(window.width, 1);
  for (size_t i = 0; i < channel.size(); ++i) channel.data()[i] = picture.data()[i].y;
  return channel;
}

TEST(Grain, FadesWithTheLevelAsTheFootprintFadesItsLobes) {
  // Coarse grain, a ripple, and fine grain; deviations of 0.02 cycles per texel.
  const Lobe lobes[] = {{0.004, 0.02, 0.0, 50, 0, 50}, {0.004, 0.06, 0.03, 50, 0, 50}, {0.002, 0.2, -0.1, 50, 0, 50}};
  Image<float> model(kLattice.count, 1);
  for (int k = 1; k < kLattice.count; ++k) {
    const Imath::V2d f = kLattice.frequency(k);
    double density = 0;
    for (const Lobe& lobe : lobes) density += lobe.density(f.x, f.y);
    model(k, 0) = static_cast<float>(std::sqrt(density / kLattice.count));
  }
  std::vector<Image<V3f>> tiles;
  tiles.push_back(realised(model, 0.125f));
  EvaluatorPlanes planes = planes_of(gray(), masks_of({1}), tiles);
  for (int level = 1; level <= 3; ++level) {
    const Image<float> values = all_blocks(planes, level);
    EXPECT_NEAR(mean_of(values), 0.625, 1e-4) << level;
    // Frequencies that fold onto one another interfere: their sum is right in the mean over the phases alone.
    const Image<float> blocks = block_spectrum(model, level);
    const NoiseLattice lattice{kLattice.count >> level, kLattice.row_step};
    EXPECT_NEAR(variance_of(values) / power_of(blocks), 1.0, 0.03) << level;
    EXPECT_LE(spectrum_difference_db(periodogram(values), blocks, lattice), 1.0) << level;
    // The closed form is that of a Gaussian footprint as wide as the block, whose transfer has no second lobe: 5 % of
    // the whole variance.
    const double width = (std::pow(4.0, level) - 1) / 12;
    EXPECT_NEAR(variance_of(values), filtered_variance(lobes, width, 0, width), 0.05 * 0.01) << level;
  }
}

}  // namespace
}  // namespace texbake
