// Times of estimate-psd at 512² (K = 3), beside the obvious estimator. Targets: 0.2 s tabulated, 1 s with the lobes.
#include <benchmark/benchmark.h>

#include <cmath>

#include "libbake/noise/estimate_psd.h"
#include "libbake/noise/noise_tile.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

constexpr int kSize = 512;

struct Field {
  Field() : exemplar(kSize, kSize), structure(kSize, kSize, V3f(0.5f)) {
    const Image<float> ring = synthetic_noise(ring_power, kSize, 0.004, 1);
    const Image<float> blob = synthetic_noise(blob_power, kSize, 0.004, 2);
    const Image<uint8_t> a = random_regions(kSize, 40, 3);
    const Image<uint8_t> b = random_regions(kSize, 40, 4);
    for (int k = 0; k < 3; ++k) masks.emplace_back(kSize, kSize);
    for (size_t i = 0; i < exemplar.size(); ++i) {
      const size_t k = a.data()[i] ? 0 : (b.data()[i] ? 1 : 2);
      masks[k].data()[i] = 1.0f;
      exemplar.data()[i] = V3f(0.5f) + V3f(1.0f, 0.8f, 0.5f) * (k == 0 ? ring : blob).data()[i] +
                           V3f(0.1f, -0.1f, 0.0f) * ring.data()[(i * 7) % ring.size()];
    }
  }
  Image<V3f> exemplar;
  Image<V3f> structure;
  std::vector<Image<float>> masks;
};

/// The spectra alone: nine channels, the masks known.
void spectra(benchmark::State& state) {
  const Field field;
  const Image<float> noise = synthetic_noise(ring_power, kSize, 0.004, 1);
  const auto estimator = static_cast<SpectrumEstimator>(state.range(0));
  for (auto _ : state)
    for (const Image<float>& mask : field.masks) {
      Image<uint8_t> texels(kSize, kSize);
      for (size_t i = 0; i < texels.size(); ++i) texels.data()[i] = mask.data()[i] > 0.5f ? 1 : 0;
      const MaskedSpectrum masked(texels, 64, estimator);
      for (int c = 0; c < 3; ++c) benchmark::DoNotOptimize(masked.estimate(noise));
    }
}
BENCHMARK(spectra)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// The same of one channel as eq. 4 is written: every lag over its pairs, by counting.
void obvious_spectrum(benchmark::State& state) {
  const Field field;
  const Image<float> noise = synthetic_noise(ring_power, kSize, 0.004, 1);
  const Image<float>& mask = field.masks[0];
  constexpr int kHalf = 32;
  for (auto _ : state) {
    Image<double> spectrum(2 * kHalf, 2 * kHalf);
    for (int dy = -kHalf; dy <= kHalf; ++dy)
      for (int dx = -kHalf; dx <= kHalf; ++dx) {
        if (dx * dx + dy * dy >= kHalf * kHalf) continue;
        double products = 0, pairs = 0;
        for (int y = 0; y < kSize; ++y)
          for (int x = 0; x < kSize; ++x) {
            const int ox = wrap(x + dx, kSize), oy = wrap(y + dy, kSize);
            const double both = double{mask(x, y)} * double{mask(ox, oy)};
            products += both * double{noise(x, y)} * double{noise(ox, oy)};
            pairs += both;
          }
        const double window = 0.5 + 0.5 * std::cos(M_PI * std::hypot(dx, dy) / kHalf);
        for (int v = 0; v < 2 * kHalf; ++v)
          for (int u = 0; u < 2 * kHalf; ++u)
            spectrum(u, v) += products / pairs * window * std::cos(M_PI * (u * dx + v * dy) / kHalf);
      }
    benchmark::DoNotOptimize(spectrum);
  }
}
BENCHMARK(obvious_spectrum)->Unit(benchmark::kMillisecond)->Iterations(1)->MeasureProcessCPUTime();

/// The whole stage: cores, color spaces, spectra, histograms, `lobes` lobes, tiles.
void whole_stage(benchmark::State& state) {
  const Field field;
  EstimatePsdOptions options;
  options.local_size = 4;
  options.lobes = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(estimate_psd(field.exemplar, field.structure, field.masks, options));
}
BENCHMARK(whole_stage)->Arg(0)->Arg(3)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void one_tile_channel(benchmark::State& state) {
  const Image<float> spectrum = true_spectrum(ring_power, 64, 0.01);
  const NoiseLattice lattice = noise_lattice(kSize);
  const auto phases = random_phases(lattice.count, 1, 0);
  for (auto _ : state) benchmark::DoNotOptimize(realise_noise(lattice_spectrum(spectrum, lattice), phases));
}
BENCHMARK(one_tile_channel)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace texbake
