// Times of decompose at 512² (K = 3), beside the obvious filter. Targets: spectra + structure 3 s, masks 1 s.
#include <benchmark/benchmark.h>

#include <cmath>

#include "libbake/noise/decompose.h"
#include "libbake/noise/structure.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

/// Two grains in regions of 60 px, in color.
Image<V3f> exemplar(int size) {
  const Image<float> ring = synthetic_noise(ring_power, size, 0.004, 1);
  const Image<float> blob = synthetic_noise(blob_power, size, 0.004, 2);
  const Image<uint8_t> region = random_regions(size, 60, 3);
  Image<V3f> image(size, size);
  for (size_t i = 0; i < image.size(); ++i)
    image.data()[i] = region.data()[i] ? V3f(0.6f, 0.4f, 0.2f) + V3f(1.0f, 0.8f, 0.5f) * ring.data()[i]
                                       : V3f(0.3f, 0.4f, 0.3f) + V3f(0.5f, 1.0f, 0.6f) * blob.data()[i];
  return image;
}

void local_spectra(benchmark::State& state) {
  const Image<float> light = luminance(exemplar(512));
  const LocalSpectra spectra(light, static_cast<int>(state.range(0)));
  for (auto _ : state)
    for (int y = 0; y < 512; y += 32) benchmark::DoNotOptimize(spectra.rows(y, y + 32));
}
BENCHMARK(local_spectra)->Arg(2)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

void spectra_and_structure(benchmark::State& state) {
  const Image<V3f> image = exemplar(512);
  const Image<float> light = luminance(image);
  for (auto _ : state) {
    const LocalSpectra spectra(light, static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(extract_structure(image, spectra));
  }
}
BENCHMARK(spectra_and_structure)
    ->Arg(2)
    ->Arg(4)
    ->Arg(8)
    ->Arg(16)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// The filter as it is written in the paper: distances again in every iteration, texel by texel.
void obvious_structure(benchmark::State& state) {
  const Image<V3f> image = exemplar(512);
  const Image<float> light = luminance(image);
  for (auto _ : state) {
    const LocalSpectra spectra(light, static_cast<int>(state.range(0)));
    const SpectraRows rows = spectra.rows(0, 512);
    Image<V3f> from = image.clone();
    for (int iteration = 0; iteration < 5; ++iteration) {
      Image<V3f> to(512, 512);
      for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
          float total = 0.0f;
          V3f sum(0.0f);
          for (int dy = kFilterBegin; dy <= kFilterEnd; ++dy)
            for (int dx = kFilterBegin; dx <= kFilterEnd; ++dx) {
              float squared = 0.0f;
              for (int b = 0; b < rows.bins(); ++b) {
                const float d = rows.row(y, b)[x] - rows.row(wrap(y + dy, 512), b)[wrap(x + dx, 512)];
                squared += d * d;
              }
              const float weight = std::exp(-squared / (2.0f * 0.01f * 0.01f));
              total += weight;
              sum += from(wrap(x + dx, 512), wrap(y + dy, 512)) * weight;
            }
          to(x, y) = sum / total;
        }
      from = std::move(to);
    }
    benchmark::DoNotOptimize(from);
  }
}
BENCHMARK(obvious_structure)
    ->Arg(4)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void masks(benchmark::State& state) {
  const Image<V3f> image = exemplar(512);
  const Image<float> light = luminance(image);
  const LocalSpectra spectra(light, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const GrainFeatures features(image, spectra, 1.0);
    benchmark::DoNotOptimize(assign_masks(features, cluster_grain(features, 3, 1), MaskKind::soft));
  }
}
BENCHMARK(masks)->Arg(4)->Arg(16)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void decompose_automatic(benchmark::State& state) {
  const Image<V3f> image = exemplar(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(decompose(image));
}
BENCHMARK(decompose_automatic)
    ->Arg(512)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace texbake
