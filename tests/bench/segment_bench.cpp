// Fragments and patches of a synthetic picture with features of many sizes and grain, at three tile sizes.
#include <benchmark/benchmark.h>

#include "libbake/base/gaussian.h"
#include "libbake/base/half.h"
#include "libbake/base/random.h"
#include "libbake/segment/contrast.h"
#include "libbake/segment/patch.h"

namespace texbake {
namespace {

struct Picture {
  PrincipalVariation colors;
  Image<V3f> base;
};

/// Blurred noise at feature size decides the class, at grain size it is the variation.
Picture picture(int size) {
  Random random(1);
  Image<float> coarse(size, size), fine(size, size);
  for (float& v : coarse) v = random.uniform() - 0.5f;
  for (float& v : fine) v = random.uniform() - 0.5f;
  const double sigma = size / 128.0;
  coarse = gaussian_blur(coarse, sigma, Wrap::repeat);
  fine = gaussian_blur(fine, 0.7, Wrap::repeat);
  const auto amplitude = static_cast<float>(3.5449 * sigma / 0.2887);  // brings the standard deviation back to 1

  Picture picture;
  for (int k = 0; k < 5; ++k)
    picture.colors.palette.classes.push_back({V3f(20 + 15 * static_cast<float>(k), 10, 20), V3f(1, 0, 0)});
  picture.colors.index = Image<uint8_t>(size, size);
  picture.colors.variation = Image<float>(size, size);
  for (size_t at = 0; at < coarse.size(); ++at) {
    const float value = std::clamp(50 + 20 * coarse.data()[at] * amplitude + 20 * fine.data()[at], 0.0f, 100.0f);
    const int k = std::clamp(static_cast<int>((value - 12.5f) / 15), 0, 4);
    picture.colors.index.data()[at] = static_cast<uint8_t>(k);
    picture.colors.variation.data()[at] = half_exact(value - (20 + 15 * static_cast<float>(k)));
  }
  picture.base = decode(picture.colors);
  return picture;
}

void fragment_bench(benchmark::State& state) {
  const Picture given = picture(static_cast<int>(state.range(0)));
  int count = 0;
  for (auto _ : state) count = fragment(given.colors, given.base).partition.count();
  state.counters["fragments"] = count;
}
BENCHMARK(fragment_bench)->Name("fragment")->Arg(512)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);

void patch_bench(benchmark::State& state) {
  const Picture given = picture(static_cast<int>(state.range(0)));
  const FragmentMap fragments = fragment(given.colors, given.base);
  for (auto _ : state) benchmark::DoNotOptimize(patch(fragments, given.base));
}
BENCHMARK(patch_bench)->Name("patch")->Arg(512)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);

void check_bench(benchmark::State& state) {
  const Picture given = picture(static_cast<int>(state.range(0)));
  const FragmentMap fragments = fragment(given.colors, given.base);
  for (auto _ : state) benchmark::DoNotOptimize(check_partition(fragments.partition));
}
BENCHMARK(check_bench)->Name("check_partition")->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace texbake
