// Time to write, read, verify and hash bundles: a 1024² material with three maps, and a 4096² color bundle.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "formats/bundle_io.h"
#include "formats/manifest.h"
#include "formats/verify.h"
#include "libbake/base/gaussian.h"
#include "libbake/base/half.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

/// Smoothed noise: compresses about as badly as a photograph.
Image<float> smooth_noise(int size, uint64_t seed) {
  Random random(seed);
  Image<float> noise(size, size);
  for (float& value : noise) value = random.uniform();
  noise = gaussian_blur(noise, 1.5, Wrap::repeat);
  for (float& value : noise) value = half_exact(value);
  return noise;
}

Partition squares(int size, int side) {
  Image<uint32_t> idx(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      idx(x, y) = static_cast<uint32_t>(wrap(y + 5, size) / side * (size / side) + wrap(x + 3, size) / side);
  return unwrap(std::move(idx));
}

Bundle synthetic_bundle(int size, int maps) {
  Bundle bundle;
  Scale& scale = bundle.scales.emplace_back();
  const Image<float> red = smooth_noise(size, 1), green = smooth_noise(size, 2), blue = smooth_noise(size, 3);
  scale.exemplar = Image<V3f>(size, size);
  for (size_t i = 0; i < scale.exemplar.size(); ++i)
    scale.exemplar.data()[i] = V3f(red.data()[i], green.data()[i], blue.data()[i]);
  scale.colors.emplace();
  for (int k = 0; k < 8; ++k) scale.colors->palette.classes.push_back({{static_cast<float>(10 * k), 0, 0}, {1, 0, 0}});
  scale.colors->variation = smooth_noise(size, 4);
  scale.colors->index = Image<uint8_t>(size, size);
  for (size_t i = 0; i < red.size(); ++i)
    scale.colors->index.data()[i] = static_cast<uint8_t>(std::clamp((red.data()[i] - 0.25f) * 16, 0.0f, 7.0f));
  scale.fragments = FragmentMap{squares(size, 16), {}};
  scale.fragments->fragments.resize(scale.fragments->partition.centers.size());
  scale.patches = PatchMap{squares(size, size / 4)};
  scale.contents = ContentTable{16, 5, std::vector<Content>(80)};
  for (int m = 0; m < maps; ++m) {
    Map& map = scale.maps.emplace_back();
    map.name = "map" + std::to_string(m);
    map.channels = m == 0 ? 3 : 1;
    for (int c = 0; c < map.channels; ++c) map.planes[c] = smooth_noise(size, static_cast<uint64_t>(10 + m * 3 + c));
  }
  return bundle;
}

class Place {
 public:
  Place() : folder_(fs::temp_directory_path() / ("texbake-bench-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Place() { fs::remove_all(folder_); }
  fs::path bundle() const { return folder_ / "a.texbundle"; }

 private:
  fs::path folder_;
};

uint64_t bytes_below(const fs::path& folder) {
  uint64_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder)) bytes += entry.file_size();
  return bytes;
}

void write_new(benchmark::State& state) {
  const Bundle bundle = synthetic_bundle(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Place place;
  for (auto _ : state) {
    state.PauseTiming();
    fs::remove_all(place.bundle());
    state.ResumeTiming();
    write_bundle(bundle, place.bundle());
  }
  state.counters["MB"] = static_cast<double>(bytes_below(place.bundle())) / 1e6;
}

void write_again(benchmark::State& state) {
  const Bundle bundle = synthetic_bundle(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Place place;
  write_bundle(bundle, place.bundle());
  for (auto _ : state) write_bundle(bundle, place.bundle());
}

void read(benchmark::State& state) {
  const Place place;
  write_bundle(synthetic_bundle(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))), place.bundle());
  for (auto _ : state) benchmark::DoNotOptimize(read_bundle(place.bundle()));
}

void verify(benchmark::State& state) {
  const Place place;
  write_bundle(synthetic_bundle(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))), place.bundle());
  for (auto _ : state) benchmark::DoNotOptimize(verify_bundle(place.bundle()));
}

void hash(benchmark::State& state) {
  const Bundle bundle = synthetic_bundle(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(plane_refs(bundle));
}

#define TEXBAKE_BUNDLE_BENCH(function) \
  BENCHMARK(function)                  \
      ->Args({1024, 3})                \
      ->Args({4096, 0})                \
      ->Unit(benchmark::kMillisecond)  \
      ->MeasureProcessCPUTime()        \
      ->UseRealTime()
TEXBAKE_BUNDLE_BENCH(write_new);
TEXBAKE_BUNDLE_BENCH(write_again);
TEXBAKE_BUNDLE_BENCH(read);
TEXBAKE_BUNDLE_BENCH(verify);
TEXBAKE_BUNDLE_BENCH(hash);

}  // namespace
}  // namespace texbake
