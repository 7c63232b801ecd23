#include "libbake/gl/gl_renderer.h"

#include <cassert>
#include <map>
#include <optional>

#include "libbake/draw/view_program.h"
#include "libbake/draw/window_program.h"
#include "libbake/gl/gl_objects.h"
#include "libbake/gl/gl_uniforms.h"

namespace texbake {
namespace {

static_assert(sizeof(glsl::FragmentTexel) == 8 && sizeof(glsl::vec4) == 16,
              "texels are uploaded as they lie in memory");

/// The target's lowest line, read first, is the top row: row `first_row` of the view.
glsl::MainUniforms main_uniforms(const TileOffset& x, const TileOffset& y, int first_row) {
  glsl::MainUniforms main;
  main.origin_tile = {x.tile, y.tile};
  main.origin_offset = {static_cast<int>(x.offset_256), static_cast<int>(y.offset_256)};
  main.first_row = {first_row, 1};
  return main;
}

glsl::MainUniforms main_uniforms(const Window& window) {
  glsl::MainUniforms main = main_uniforms(window.origin_x, window.origin_y, 0);
  main.step_256 = window.step_256;
  main.filter_kind = smooth_filter(window.filter);
  return main;
}

glsl::MainUniforms main_uniforms(const Perspective& view, const V3f& sky, int first_row) {
  glsl::MainUniforms main = main_uniforms(view.origin_x, view.origin_y, first_row);
  main.sky = {sky.x, sky.y, sky.z, 0};
  return main;
}

}  // namespace

struct GlRenderer::State {
  const GlFunctions& gl;
  const EvaluatorPlanes* tile = nullptr;  ///< this, or the stack
  const StackPlanes* stack = nullptr;
  const ReliefPlanes flat{};
  const ReliefPlanes* relief = nullptr;
  GlProgram program;
  std::map<const void*, GlTexture> textures;  ///< by their images
  std::optional<GlTarget> target;
  GLuint vertex_array = 0;

  State(const GlContext& context, const std::string& fragment_shader)
      : gl(context.functions()), program(gl, reference_vertex_shader(context.language()), fragment_shader) {
    gl.GenVertexArrays(1, &vertex_array);
  }
  ~State() { gl.DeleteVertexArrays(1, &vertex_array); }

  /// Calls visit for every texture that is drawn: of the tile those of `plane`.
  template <class Visitor>
  void for_each_drawn_texture(const Plane* plane, const Visitor& visit) const {
    if (tile) return for_each_texture(*tile, *plane, visit);
    for_each_texture(*stack, visit);
    for_each_texture(relief ? *relief : flat, visit);
  }

  /// One texel of zeros stands for what is empty.
  template <class T>
  void upload(const Image<T>& image) {
    constexpr uint32_t kZeros[4] = {};
    if (textures.contains(&image)) return;
    const bool empty = image.empty();
    textures.try_emplace(&image, gl, kGlFormat<T>, empty ? 1 : image.width(), empty ? 1 : image.height(),
                         empty ? static_cast<const void*>(kZeros) : image.data());
  }

  /// Makes the target, the program and the textures current.
  void begin(int width, int height, const Plane* plane) {
    if (!target || target->width() != width || target->height() != height) target.emplace(gl, width, height);
    target->bind();
    gl.UseProgram(program.name());
    // First all uploads: an upload binds.
    for_each_drawn_texture(plane, [&](const Texture&, const auto& image, auto) { upload(image); });
    int unit = 0;
    for_each_drawn_texture(plane, [&](const Texture& texture, const auto& image, auto) {
      textures.at(&image).bind(unit);
      gl.Uniform1i(program.uniform(texture.name), unit++);
    });
  }

  template <class BoundProgram>
  void draw(const BoundProgram& bound, const glsl::MainUniforms& main) {
    set_uniforms(gl, program, bound);
    set_uniforms(gl, program, main);
    gl.BindVertexArray(vertex_array);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Finish();
  }

  glsl::Program stack_program(uint32_t seed, const glsl::uvec2& reference) const {
    glsl::Program bound = program_of(*stack, seed, reference);
    if (relief) bind_relief(bound, *relief);
    return bound;
  }
};

GlRenderer::GlRenderer(const GlContext& context, const EvaluatorPlanes& planes)
    : GlRenderer(context, planes, reference_fragment_shader(context.language())) {}

GlRenderer::GlRenderer(const GlContext& context, const EvaluatorPlanes& planes, const std::string& fragment_shader)
    : state_(std::make_unique<State>(context, fragment_shader)) {
  state_->tile = &planes;
}

GlRenderer::GlRenderer(const GlContext& context, const StackPlanes& planes, const ReliefPlanes* relief)
    : GlRenderer(context, planes, stack_fragment_shader(context.language()), relief) {}

GlRenderer::GlRenderer(const GlContext& context, const StackPlanes& planes, const std::string& fragment_shader,
                       const ReliefPlanes* relief)
    : state_(std::make_unique<State>(context, fragment_shader)) {
  state_->stack = &planes;
  state_->relief = relief;
}

GlRenderer::~GlRenderer() = default;

void GlRenderer::draw_only(const Window& window, const Plane& plane) {
  State& s = *state_;
  assert(s.tile);
  check_window(window, s.tile->size);
  s.begin(window.width, window.height, &plane);
  glsl::Program bound = program_of(*s.tile, window);
  if (&plane != &s.tile->base) bound.deformed = 0;
  glsl::MainUniforms main = main_uniforms(window);
  main.level_256 = level_256_of(window, s.tile->level_count);
  main.plane_kind = plane_kind(plane.kind);
  s.draw(bound, main);
}

void GlRenderer::draw_only(const Perspective& view, const Plane& plane, int row_begin, int row_end) {
  State& s = *state_;
  assert(s.tile);
  check_perspective(view, s.tile->size);
  s.begin(view.width, row_end - row_begin, &plane);
  glsl::MainUniforms main = main_uniforms(view, &plane == &s.tile->base ? view.sky : V3f(0), row_begin);
  main.plane_kind = plane_kind(plane.kind);
  s.draw(perspective_program_of(*s.tile, view), main);
}

void GlRenderer::draw_only(const Window& window, const ScaleView& view, const Direction& viewer) {
  State& s = *state_;
  assert(s.stack);
  check_window(window, s.stack->sizes.back());
  s.begin(window.width, window.height, nullptr);
  glsl::MainUniforms main = main_uniforms(window);
  main.view_scale = view.scale;
  main.level_256 = view.level_256;
  main.fading = view.fading;
  main.variation = view.variation;
  main.slant = slant_of(*s.stack, viewer, window);
  s.draw(s.stack_program(window.seed, {window.origin_x.tile, window.origin_y.tile}), main);
}

void GlRenderer::draw_only(const Perspective& view, int row_begin, int row_end) {
  State& s = *state_;
  assert(s.stack);
  check_perspective(view, s.stack->sizes.back());
  s.begin(view.width, row_end - row_begin, nullptr);
  const glsl::Program bound = s.stack_program(view.seed, {view.origin_x.tile, view.origin_y.tile});
  s.draw(with_view(bound, view), main_uniforms(view, view.sky, row_begin));
}

Frame GlRenderer::read() const {
  const GlTarget& target = *state_->target;
  Frame frame{Image<glsl::vec4>(target.width(), target.height(), {0, 0, 0, 0}),
              Image<PixelDecision>(target.width(), target.height())};
  target.read_values(frame.values.data());
  target.read_decisions(frame.decisions.data());
  return frame;
}

Frame GlRenderer::draw(const Window& window, const Plane& plane) {
  draw_only(window, plane);
  return read();
}

Frame GlRenderer::draw(const Perspective& view, const Plane& plane) { return draw(view, plane, 0, view.height); }

Frame GlRenderer::draw(const Perspective& view, const Plane& plane, int row_begin, int row_end) {
  draw_only(view, plane, row_begin, row_end);
  return read();
}

Frame GlRenderer::draw(const Window& window, const ScaleView& view, const Direction& viewer) {
  draw_only(window, view, viewer);
  return read();
}

Frame GlRenderer::draw(const Perspective& view, int row_begin, int row_end) {
  draw_only(view, row_begin, row_end);
  return read();
}

}  // namespace texbake
