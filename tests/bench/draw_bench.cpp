// Pixels per second of the evaluator, beside a plain periodic lookup in the same run, and of a plane of two scales
// beside the plain walk of the reference text. `items_per_second` is pixels.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "libbake/draw/show.h"
#include "libbake/draw/stack_perspective.h"
#include "libbake/draw/window_program.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/stack_levels.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

constexpr int kTile = 512;
constexpr int kWidth = 2048, kHeight = 512;

const EvaluatorPlanes& planes_of(Contents kind) {
  static const EvaluatorPlanes moved = random_tile({kTile, kTile}, 5, Contents::moved, 1).planes();
  static const EvaluatorPlanes turned = random_tile({kTile, kTile}, 5, Contents::turned, 1).planes();
  return kind == Contents::moved ? moved : turned;
}

/// The same with three noises, whose masks are soft at most texels.
const EvaluatorPlanes& noise_planes(Contents kind) {
  const auto made = [](Contents of) {
    SmallTile tile = random_tile({kTile, kTile}, 5, of, 1);
    add_noise(tile, 3, kTile, 1);
    return tile.planes();
  };
  static const EvaluatorPlanes moved = made(Contents::moved);
  static const EvaluatorPlanes turned = made(Contents::turned);
  return kind == Contents::moved ? moved : turned;
}

const EvaluatorPlanes& periodic_planes() {
  static const Image<V3f> base = random_base({kTile, kTile}, 1);
  static const EvaluatorPlanes planes = [] {
    EvaluatorInput input;
    input.base = base;
    return prepare(input);
  }();
  return planes;
}

Window bench_window(Filter filter, uint32_t step_256) {
  Window window;
  window.origin_x = tile_offset(-777, 100, kTile);
  window.origin_y = tile_offset(int64_t{1} << 40, 33, kTile);
  window.step_256 = step_256;
  window.width = kWidth;
  window.height = kHeight;
  window.seed = 1;
  window.filter = filter;
  return window;
}

void draw(benchmark::State& state, const EvaluatorPlanes& planes, Filter filter, uint32_t step_256) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(state.range(0)));
  const Window window = bench_window(filter, step_256);
  // By blocks of rows, as a picture is streamed to a file.
  constexpr int kBlock = 128;
  for (auto _ : state)
    for (int j = 0; j < kHeight; j += kBlock) benchmark::DoNotOptimize(render_rows(planes, window, j, j + kBlock));
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
}

void window_nearest(benchmark::State& state) { draw(state, planes_of(Contents::moved), Filter::nearest, 256); }
void window_bilinear(benchmark::State& state) { draw(state, planes_of(Contents::moved), Filter::bilinear, 256); }
void window_bilinear_magnified(benchmark::State& s) { draw(s, planes_of(Contents::moved), Filter::bilinear, 64); }
void window_bilinear_skipping(benchmark::State& s) { draw(s, planes_of(Contents::moved), Filter::bilinear, 900); }
void window_bilinear_turned(benchmark::State& state) {
  draw(state, planes_of(Contents::turned), Filter::bilinear, 256);
}
void window_noise(benchmark::State& s) { draw(s, noise_planes(Contents::moved), Filter::bilinear, 256); }
void window_noise_turned(benchmark::State& s) { draw(s, noise_planes(Contents::turned), Filter::bilinear, 256); }
void window_periodic_bilinear(benchmark::State& state) { draw(state, periodic_planes(), Filter::bilinear, 256); }
BENCHMARK(window_nearest)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(window_bilinear)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(window_bilinear_magnified)->Arg(1)->UseRealTime();
BENCHMARK(window_bilinear_skipping)->Arg(1)->UseRealTime();
BENCHMARK(window_bilinear_turned)->Arg(1)->UseRealTime();
BENCHMARK(window_noise)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(window_noise_turned)->Arg(1)->UseRealTime();
BENCHMARK(window_periodic_bilinear)->Arg(1)->UseRealTime();

/// Single points by the shader's own walk: what a renderer of arbitrary geometry calls.
template <class Point>
void walk(benchmark::State& state, const EvaluatorPlanes& planes, const Point& point) {
  glsl::Program program = program_of(planes, 1);
  const Window window = bench_window(Filter::bilinear, 256);
  Image<V3f> out(kWidth, kHeight);
  for (auto _ : state) {
    for (int j = 0; j < kHeight; ++j)
      for (int i = 0; i < kWidth; ++i) {
        const glsl::vec4 value =
            point(program, program.pixel_position(origin_of(window), window.step_256,
                                                  {static_cast<uint32_t>(i), static_cast<uint32_t>(j)}));
        out(i, j) = {value.x, value.y, value.z};
      }
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
}

void point_bilinear(benchmark::State& state) {
  walk(state, planes_of(Contents::moved), [](glsl::Program& program, const glsl::Position& at) {
    return program.footprint_value(program.base, program.footprint_at(at));
  });
}
BENCHMARK(point_bilinear);

/// The plain bilinear lookup of a periodic picture: four fetches and three lerps.
void point_periodic_bilinear(benchmark::State& state) {
  walk(state, planes_of(Contents::moved), [](glsl::Program& program, const glsl::Position& at) {
    const glsl::Position corner = program.upper_left_center(at);
    const glsl::Texel texel = program.texel_at(corner);
    const glsl::ivec2 p = texel.p, q = program.next_texel(p, program.tile_size);
    const auto fetch = [&](int x, int y) { return texelFetch(program.base, {x, y}, 0); };
    return program.bilinear(fetch(p.x, p.y), fetch(q.x, p.y), fetch(p.x, q.y), fetch(q.x, q.y),
                            {corner.offset.x & 255, corner.offset.y & 255});
  });
}
BENCHMARK(point_periodic_bilinear);

/// Two scales as a bake of photographs has them: eight contents, soft borders, fragments of 16 × 16 texels.
const SmallStack& two_photographs() {
  static const SmallStack stack = [] {
    constexpr V2i kSize(1024, 1024);
    SmallStack made;
    for (const uint64_t seed : {1, 2}) {
      ScaleTile tile = random_scale(kSize, 8, Contents::moved, seed);
      tile.tile.soft_border_px = 3;
      tile.fragments = square_fragments(kSize, 16);
      made.add(std::move(tile), {.ratio = 16});
    }
    return made;
  }();
  return stack;
}

template <class Draw>
void draw_plane(benchmark::State& state, Filter filter, const Draw& draw) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(state.range(0)));
  static const StackPlanes planes = two_photographs().planes();
  Perspective view;
  view.width = 1200;
  view.height = 800;
  view.filter = filter;
  for (auto _ : state) benchmark::DoNotOptimize(draw(planes, view));
  state.SetItemsProcessed(state.iterations() * view.width * view.height);
}

void stack_plane(benchmark::State& state, Filter filter) {
  draw_plane(state, filter, [](const StackPlanes& planes, const Perspective& view) {
    return render_stack_perspective_rows(planes, nullptr, view, 0, view.height);
  });
}
void stack_plane_plain(benchmark::State& state, Filter filter) {
  draw_plane(state, filter, [](const StackPlanes& planes, const Perspective& view) {
    return stack_perspective_frame(planes, nullptr, view);
  });
}
BENCHMARK_CAPTURE(stack_plane, trilinear, Filter::trilinear)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(stack_plane_plain, trilinear, Filter::trilinear)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(stack_plane, anisotropic, Filter::anisotropic)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK_CAPTURE(stack_plane_plain, anisotropic, Filter::anisotropic)->Arg(1)->Arg(2)->UseRealTime();

void stack_levels(benchmark::State& state) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(two_photographs().planes());
}
BENCHMARK(stack_levels)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace texbake
