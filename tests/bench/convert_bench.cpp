// Time of `convert` and of its parts on a synthetic photograph: blobs of five hues with grain.
#include <benchmark/benchmark.h>

#include "libbake/color/auto_classes.h"
#include "libbake/color/convert.h"
#include "libbake/color/luv.h"
#include "libbake/color/octree.h"
#include "tests/libbake/color/points.h"

namespace texbake {
namespace {

Image<V3f> photograph(int size) {
  constexpr float kHues[5][3] = {{16, 20, 12}, {33, 32, 28}, {35, -8, 33}, {46, 33, 40}, {58, 25, 48}};
  Random random(1);
  Image<V3f> image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const float* hue = kHues[((x / 24) * 7 + (y / 16) * 3) % 5];
      const float t = 7 * normal(random);
      const V3f luv(hue[0] + 0.5f * t, hue[1] + 0.7f * t + 2 * random.uniform(), hue[2] + 0.5f * t + random.uniform());
      image(x, y) = linear_from_luv(luv);
    }
  return image;
}

void BM_Convert(benchmark::State& state) {
  const Image<V3f> image = photograph(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(convert(image, {}));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(image.size()));
}
BENCHMARK(BM_Convert)->Arg(512)->Arg(1024)->Arg(2048)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_LuvFromLinear(benchmark::State& state) {
  const Image<V3f> image = photograph(1024);
  for (auto _ : state) benchmark::DoNotOptimize(luv_from_linear(image.view()));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(image.size()));
}
BENCHMARK(BM_LuvFromLinear)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_Decode(benchmark::State& state) {
  const Conversion conversion = convert(photograph(1024), {});
  for (auto _ : state) benchmark::DoNotOptimize(decode(conversion.colors));
  state.SetItemsProcessed(state.iterations() * (1 << 20));
}
BENCHMARK(BM_Decode)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_OctreeQuantize(benchmark::State& state) {
  const Image<V3f> image = photograph(512);
  const PointSet points = sample({image, {}, 0}, 1 << 14);
  for (auto _ : state) benchmark::DoNotOptimize(octree_quantize(points, static_cast<int>(state.range(0)), 1));
}
BENCHMARK(BM_OctreeQuantize)->Arg(5)->Arg(64)->Unit(benchmark::kMillisecond);

void BM_BestLines(benchmark::State& state) {
  const Image<V3f> image = photograph(512);
  const PointSet points = sample({image, {}, 0}, 1 << 14);
  for (auto _ : state) benchmark::DoNotOptimize(best_lines(points, static_cast<int>(state.range(0)), 0.1f));
}
BENCHMARK(BM_BestLines)->Arg(5)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace texbake
