// Times the stage select-contents, and in the same run the obvious loop over eq. 2 and 3 that its search replaces.
#include <benchmark/benchmark.h>

#include "libbake/base/parallel.h"
#include "libbake/content/pair_impact.h"
#include "libbake/content/refined_search.h"
#include "libbake/content/saliency.h"
#include "libbake/content/turned_search.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

constexpr int kClassCount = 8;
constexpr int kPatchCount = 16;

struct Tile {
  explicit Tile(int side)
      : classes(twin::random_classes(side, side, kClassCount, 1)),
        distances(class_distances(twin::random_colors(kClassCount, 1))),
        patches(twin::random_patches(side, side, kPatchCount, 1)),
        borders(patch_borders(patches, kPatchCount)),
        request{120, side / 16} {}

  Image<uint8_t> classes;
  ClassDistances distances;
  Image<uint32_t> patches;
  PatchBorders borders;
  SearchRequest request;
};

// δ from each class to the tile, which stands there twice along each axis.
struct DistancePlanes {
  explicit DistancePlanes(const Tile& tile)
      : side(tile.classes.width()), stride(2 * static_cast<size_t>(side) + 2 * kMaskRadius) {
    for (int a = 0; a < kClassCount; ++a)
      for (int y = -kMaskRadius; y < 2 * side + kMaskRadius; ++y)
        for (int x = -kMaskRadius; x < 2 * side + kMaskRadius; ++x)
          values.push_back(tile.distances.at(a, tile.classes(wrap(x, side), wrap(y, side))));
  }
  const uint16_t* at(int class_idx, int x, int y) const {
    return values.data() + (static_cast<size_t>(class_idx) * stride + static_cast<size_t>(y + kMaskRadius)) * stride +
           static_cast<size_t>(x + kMaskRadius);
  }

  int side;
  size_t stride;
  std::vector<uint16_t> values;
};

// sums[i] += from[i]: one of the 49 terms, and sums[i] += box[i] · own[i], for a row of translations. The compiler
// makes vectors of these loops, in the instruction set given.
#define TEXBAKE_OBVIOUS_ROW(name, attribute)                                                       \
  struct name {                                                                                    \
    attribute static void add(const uint16_t* __restrict from, uint16_t* __restrict sums, int n) { \
      for (int i = 0; i < n; ++i) sums[i] = static_cast<uint16_t>(sums[i] + from[i]);              \
    }                                                                                              \
    attribute static void multiply(const uint16_t* __restrict box, const uint16_t* __restrict own, \
                                   uint64_t* __restrict sums, int n) {                             \
      for (int i = 0; i < n; ++i) sums[i] += static_cast<uint32_t>(box[i]) * own[i];               \
    }                                                                                              \
  };
TEXBAKE_OBVIOUS_ROW(BaselineRow, )
#if defined(__x86_64__)
TEXBAKE_OBVIOUS_ROW(Avx2Row, __attribute__((target("avx2"))))
#endif

// Every term of eq. 2 and 3, for every translation, a row of them at a time.
template <class Row>
std::vector<Candidates> obvious_search(const Tile& tile) {
  const int side = tile.classes.width();
  const DistancePlanes planes(tile);
  std::vector<Candidates> all(kPatchCount);
  for (int patch = 0; patch < kPatchCount; ++patch) {
    const std::vector<V2i> border = twin::dilated_border(tile.patches, static_cast<uint32_t>(patch));
    Image<uint64_t> sums(side, side);
    parallel_for(0, side, [&](int t_y) {
      std::vector<uint16_t> box(static_cast<size_t>(side));
      for (const V2i& p : border) {
        std::fill(box.begin(), box.end(), uint16_t{0});
        for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy)
          for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) {
            const int class_idx = tile.classes(wrap(p.x + dx, side), wrap(p.y + dy, side));
            Row::add(planes.at(class_idx, p.x + dx, p.y + dy + t_y), box.data(), side);
          }
        Row::multiply(box.data(), planes.at(tile.classes(p.x, p.y), p.x, p.y + t_y), sums.row(t_y), side);
      }
    });
    Candidates& found = all[static_cast<size_t>(patch)];
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) found.push_back({{x, y}, sums(x, y)});
    found = take_separated(found, {side, side}, tile.request);
  }
  return all;
}

// What the fast search found last at 512²: the obvious loop must find the same.
std::vector<Candidates> g_found;

void BM_ContentSearchExact(benchmark::State& state) {
  const Tile tile(static_cast<int>(state.range(0)));
  SearchResult result;
  for (auto _ : state) result = search_contents(tile.classes, tile.distances, tile.borders, tile.request);
  state.counters["computed_share"] =
      static_cast<double>(result.error_count) / static_cast<double>(result.all_error_count);
  if (state.range(0) == 512) g_found = std::move(result.candidates);
}
BENCHMARK(BM_ContentSearchExact)
    ->Arg(512)
    ->Arg(1024)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

template <class Row>
void BM_ContentSearchObvious(benchmark::State& state) {
  const Tile tile(512);
  for (auto _ : state)
    if (obvious_search<Row>(tile) != g_found) state.SkipWithError("the searches differ");
}
BENCHMARK_TEMPLATE(BM_ContentSearchObvious, BaselineRow)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
#if defined(__x86_64__)
BENCHMARK_TEMPLATE(BM_ContentSearchObvious, Avx2Row)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
#endif

void BM_ContentSearchRefined(benchmark::State& state) {
  const Tile tile(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        search_contents_refined(tile.classes, tile.distances, tile.patches, kPatchCount, tile.request));
}
BENCHMARK(BM_ContentSearchRefined)
    ->Arg(4096)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

// With the centers of the patches, about which contents are turned.
Partition partition_of(const Tile& tile) {
  Partition patches = twin::partition(tile.patches.clone(), kPatchCount);
  std::vector<V2i> first(kPatchCount, V2i(-1, -1)), sums(kPatchCount, V2i(0, 0));
  std::vector<int> counts(kPatchCount, 0);
  for (int y = 0; y < tile.patches.height(); ++y)
    for (int x = 0; x < tile.patches.width(); ++x) {
      const uint32_t patch = tile.patches(x, y);
      if (counts[patch]++ == 0) first[patch] = {x, y};
      sums[patch] += shortest(V2i(x, y) - first[patch], patches.size());
    }
  for (size_t i = 0; i < kPatchCount; ++i) patches.centers[i] = wrap(first[i] + sums[i] / counts[i], patches.size());
  return patches;
}

// What a whole stage with rotations and scales searches: 8 directions at 3 sizes.
void BM_ContentSearchTurned(benchmark::State& state) {
  const Tile tile(static_cast<int>(state.range(0)));
  const Partition patches = partition_of(tile);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        search_contents_turned(tile.classes, tile.distances, patches, make_turns(8, 3, 0.5f), tile.request));
}
BENCHMARK(BM_ContentSearchTurned)
    ->Arg(512)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void BM_PairImpact(benchmark::State& state) {
  const Tile tile(1024);
  const Partition patches = partition_of(tile);
  std::vector<std::vector<V2i>> translations(kPatchCount);
  Random random(1);
  for (auto& of_patch : translations)
    for (int i = 0; i < 5; ++i)
      of_patch.emplace_back(static_cast<int>(random.below(1024)), static_cast<int>(random.below(1024)));
  const ContentTable table = twin::table(translations);
  for (auto _ : state) benchmark::DoNotOptimize(pair_impact(tile.classes, tile.distances, patches, table));
}
BENCHMARK(BM_PairImpact)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

void BM_Saliency(benchmark::State& state) {
  const Tile tile(1024);
  PrincipalVariation colors;
  colors.palette.classes.resize(kClassCount);
  colors.index = tile.classes.clone();
  colors.variation = Image<float>(1024, 1024);
  Random random(2);
  for (float& v : colors.variation) v = random.uniform();
  for (auto _ : state) benchmark::DoNotOptimize(saliency(colors));
}
BENCHMARK(BM_Saliency)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace texbake
