// Frames of 1200 × 800 on OpenGL: nothing, the plain periodic picture, and the reference; ratios within one run.
#include <benchmark/benchmark.h>

#include "libbake/gl/gl_renderer.h"
#include "tests/libbake/eval/small_tile.h"

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

}  // namespace
}  // namespace texbake
