// How long heightmap takes, and how well it recovers heights that are known: means over draws of clicks, chosen as
// a person would and at random. Reads the photographs with heights from the folder TEXBAKE_TEXTURES, at 512 x 512.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <map>

#include "formats/image_reader.h"
#include "libbake/color/convert.h"
#include "libbake/height/shading.h"
#include "libbake/tile/resample.h"
#include "tests/libbake/height/known_height.h"
#include "tests/libbake/height/obvious_heights.h"

namespace texbake {
namespace {

constexpr int kSide = 512;
constexpr int kDraws = 12;

struct Photograph {
  Image<V3f> base;
  PrincipalVariation colors;
  Image<float> truth;
};

Image<V3f> read(const std::string& name, PictureRole role) {
  const char* folder = std::getenv("TEXBAKE_TEXTURES");
  if (!folder) throw Error(ErrorKind::usage, "set TEXBAKE_TEXTURES to the folder of the photographs");
  const Picture picture = read_picture({.path = std::string(folder) + "/" + name, .role = role});
  const Image<float>* planes = picture.planes;
  const bool gray = picture.channels == 1;
  const Image<V3f> image = interleave({planes[0].clone(), planes[gray ? 0 : 1].clone(), planes[gray ? 0 : 2].clone()});
  return picture.width() == kSide ? image.clone() : resample(image, kSide, kSide, Borders{});
}

const Photograph& photograph(const std::string& color, const std::string& height) {
  static std::map<std::string, Photograph> known;
  const auto found = known.find(color);
  if (found != known.end()) return found->second;
  Photograph photo{read(color, PictureRole::color), {}, Image<float>(kSide, kSide)};
  photo.colors = convert(photo.base, {}).colors;
  const Image<V3f> heights = read(height, PictureRole::data);
  for (size_t i = 0; i < heights.size(); ++i) photo.truth.data()[i] = heights.data()[i].x;
  return known.emplace(color, std::move(photo)).first->second;
}

template <class Clicks>
double mean_correlation(const Photograph& photo, const HeightmapOptions& options, int count, const Clicks& clicks) {
  double sum = 0;
  for (uint64_t seed = 1; seed <= kDraws; ++seed) {
    const Heightmap map = heightmap(photo.colors, photo.base, clicks(photo.truth, count, seed), options);
    sum += correlation(map.height_01, photo.truth);
  }
  return sum / kDraws;
}

void BM_Recover(benchmark::State& state, const char* color, const char* height, HeightmapOptions options) {
  const Photograph& photo = photograph(color, height);
  const auto count = static_cast<int>(state.range(0));
  for (auto _ : state) {
    state.counters["chosen"] = mean_correlation(photo, options, count, twin::chosen_clicks);
    state.counters["random"] = mean_correlation(photo, options, count, twin::random_clicks);
  }
}

void BM_Heightmap(benchmark::State& state, HeightmapOptions options) {
  const Photograph& photo = photograph("bark/albedo.png", "bark/height.png");
  const auto clicks = twin::random_clicks(photo.truth, static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(heightmap(photo.colors, photo.base, clicks, options));
}

// The obvious loop in one thread, without smoothing.
void BM_Obvious(benchmark::State& state) {
  const Photograph& photo = photograph("bark/albedo.png", "bark/height.png");
  const auto clicks = twin::random_clicks(photo.truth, static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(twin::obvious_heights(photo.base, clicks));
}

HeightmapOptions paper() {
  HeightmapOptions options;
  options.descriptor = HeightDescriptor::gradients;
  return options;
}

#define TEXBAKE_RECOVER(name, color, height)                              \
  BENCHMARK_CAPTURE(BM_Recover, name, color, height, {})                  \
      ->Arg(10)                                                           \
      ->Arg(30)                                                           \
      ->Arg(100)                                                          \
      ->Iterations(1)                                                     \
      ->Unit(benchmark::kSecond);                                         \
  BENCHMARK_CAPTURE(BM_Recover, name##_gradients, color, height, paper()) \
      ->Arg(10)                                                           \
      ->Arg(30)                                                           \
      ->Arg(100)                                                          \
      ->Iterations(1)                                                     \
      ->Unit(benchmark::kSecond)
TEXBAKE_RECOVER(bark, "bark/albedo.png", "bark/height.png");
TEXBAKE_RECOVER(cracked_earth, "cracked_earth/albedo.jpg", "cracked_earth/height.png");
TEXBAKE_RECOVER(mossy_rock, "mossy_rock/albedo.jpg", "mossy_rock/height.jpg");

BENCHMARK_CAPTURE(BM_Heightmap, appearance, {})
    ->Arg(10)
    ->Arg(3000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Heightmap, gradients, paper())
    ->Arg(10)
    ->Arg(3000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BM_Obvious)->Arg(10)->Arg(3000)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace texbake
