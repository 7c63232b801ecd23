// Frames of 1200 × 800 on OpenGL: nothing, the plain periodic picture, and the reference; planes in perspective of one
// scale, two scales, and two with relief (CE13, table 1: 84, 45 and 34 % of the frames of the untextured one). Ratios
// within one run.
#include <benchmark/benchmark.h>

#include "libbake/gl/gl_renderer.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/stack_levels.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

constexpr ShaderLanguage kLanguage = ShaderLanguage::glsl_330;

/// `main` of a shader that draws `expression` at every pixel; `at` is the pixel's position.
std::string shader_with(const std::string& expression) {
  return reference_core(kLanguage) + R"glsl(
uniform uvec2 origin_tile;
uniform ivec2 origin_offset;
uniform uint step_256;
layout(location = 0) out vec4 value;
layout(location = 1) out uvec4 decided;
vec4 fetched(int x, int y) { return texelFetch(base, ivec2(x, y), 0); }
vec4 periodic(Position at) {
  Position corner = upper_left_center(at);
  ivec2 p = texel_at(corner).p;
  ivec2 q = next_texel(p, tile_size);
  return bilinear(fetched(p.x, p.y), fetched(q.x, p.y), fetched(p.x, q.y), fetched(q.x, q.y), corner.offset & 255);
}
void main() {
  Position origin;
  origin.tile = origin_tile;
  origin.offset = origin_offset;
  Position at = pixel_position(origin, step_256, uvec2(gl_FragCoord.xy));
  decided = uvec4(0u);
  value = )glsl" +
         expression + ";\n}\n";
}

void draw(benchmark::State& state, const std::string& fragment_shader) {
  const SmallTile tile = random_tile({512, 512}, 5, Contents::moved, 1);
  const EvaluatorPlanes planes = tile.planes();
  const GlContext context({kLanguage, std::nullopt});
  GlRenderer renderer(context, planes, fragment_shader);
  Window window;
  window.width = 1200;
  window.height = 800;
  window.step_256 = 200;
  for (auto _ : state) renderer.draw_only(window, planes.base);
  state.SetLabel(context.description());
  state.SetItemsProcessed(state.iterations() * window.width * window.height);
}

void untextured(benchmark::State& state) { draw(state, shader_with("vec4(at.offset, 0, 0)")); }
void periodic(benchmark::State& state) { draw(state, shader_with("periodic(at)")); }
void reference_values(benchmark::State& state) { draw(state, shader_with("footprint_value(base, footprint_at(at))")); }
void reference(benchmark::State& state) { draw(state, reference_fragment_shader(kLanguage)); }
BENCHMARK(untextured)->UseRealTime();
BENCHMARK(periodic)->UseRealTime();
BENCHMARK(reference_values)->UseRealTime();
BENCHMARK(reference)->UseRealTime();

Perspective plane_view(Filter filter) {
  Perspective view;
  view.width = 1200;
  view.height = 800;
  view.height_texels = 400;
  view.filter = filter;
  return view;
}

/// `main` of a shader that draws nothing but where a pixel sees the plane.
std::string plain_plane() {
  return reference_core(kLanguage) + std::string(shader_text("perspective_bindings.glsl")) +
         std::string(shader_text("perspective.glsl")) + R"glsl(
uniform uvec2 origin_tile;
uniform ivec2 origin_offset;
layout(location = 0) out vec4 value;
layout(location = 1) out uvec4 decided;
void main() {
  Position below;
  below.tile = origin_tile;
  below.offset = origin_offset;
  Sight sight = sight_at(below, gl_FragCoord.x, gl_FragCoord.y);
  decided = uvec4(0u);
  value = vec4(sight.probes.at.offset, sight.probes.level_256, sight.probes.axis_256.x);
}
)glsl";
}

void draw_plane(benchmark::State& state, const std::string& fragment_shader, Filter filter) {
  EvaluatorPlanes planes = random_tile({512, 512}, 5, Contents::moved, 1).planes();
  const GlContext context({kLanguage, std::nullopt});
  GlRenderer renderer(context, planes, fragment_shader);
  const Perspective view = plane_view(filter);
  renderer.draw_only(view, planes.base, 0, view.height);  // the driver compiles when it first draws
  for (auto _ : state) renderer.draw_only(view, planes.base, 0, view.height);
  state.SetLabel(context.description());
  state.SetItemsProcessed(state.iterations() * view.width * view.height);
}

enum class WithRelief { no, yes };

void draw_stack(benchmark::State& state, WithRelief with_relief, Filter filter) {
  SmallStack stack;
  stack.add(random_scale({512, 512}, 5, Contents::moved, 1))
      .add(random_scale({512, 512}, 5, Contents::moved, 2), {.ratio = 16});
  StackPlanes planes = stack.planes();
  Image<float> height(512, 512);
  Random random(3, 1);
  for (float& h : height) h = random.uniform();
  EvaluatorInput input = stack.tiles.front().input();
  input.maps.push_back({"height", MapKind::height, {height}});
  const ReliefPlanes relief = relief_planes(input, {.depth_px = 4}, {-1, -1, 1.5f});
  const GlContext context({kLanguage, std::nullopt});
  GlRenderer renderer(context, planes, stack_perspective_fragment_shader(kLanguage),
                      with_relief == WithRelief::yes ? &relief : nullptr);
  const Perspective view = plane_view(filter);
  renderer.draw_only(view, 0, view.height);
  for (auto _ : state) renderer.draw_only(view, 0, view.height);
  state.SetLabel(context.description());
  state.SetItemsProcessed(state.iterations() * view.width * view.height);
}

void plane_untextured(benchmark::State& state) { draw_plane(state, plain_plane(), Filter::trilinear); }
void plane_one_scale(benchmark::State& state, Filter filter) {
  draw_plane(state, perspective_fragment_shader(kLanguage), filter);
}
void plane_two_scales(benchmark::State& state, Filter filter) { draw_stack(state, WithRelief::no, filter); }
void plane_two_scales_relief(benchmark::State& state, Filter filter) { draw_stack(state, WithRelief::yes, filter); }
BENCHMARK(plane_untextured)->UseRealTime();
BENCHMARK_CAPTURE(plane_one_scale, nearest, Filter::nearest)->UseRealTime();
BENCHMARK_CAPTURE(plane_two_scales, nearest, Filter::nearest)->UseRealTime();
BENCHMARK_CAPTURE(plane_two_scales_relief, nearest, Filter::nearest)->UseRealTime();
BENCHMARK_CAPTURE(plane_one_scale, trilinear, Filter::trilinear)->UseRealTime();
BENCHMARK_CAPTURE(plane_two_scales, trilinear, Filter::trilinear)->UseRealTime();
BENCHMARK_CAPTURE(plane_two_scales_relief, trilinear, Filter::trilinear)->UseRealTime();

}  // namespace
}  // namespace texbake
