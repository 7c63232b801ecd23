#include "libbake/gl/gl_stack_renderer.h"

#include <array>
#include <optional>

#include "libbake/gl/gl_objects.h"
#include "libbake/gl/gl_view.h"

namespace texbake {
namespace {

/// One texel of zeros stands for levels that were not added.
template <class T>
GlTexture upload(const GlFunctions& gl, const GlFormat& format, const Image<T>& image) {
  constexpr uint32_t kZeros[4] = {};
  if (image.empty()) return GlTexture(gl, format, 1, 1, kZeros);
  return GlTexture(gl, format, image.width(), image.height(), image.data());
}

static_assert(sizeof(glsl::uvec4) == 16 && sizeof(glsl::ivec2) == 8 && sizeof(glsl::FragmentTexel) == 8,
              "uniforms and texels are given to OpenGL as they lie in memory");

}  // namespace

struct GlStackRenderer::State {
  struct Bound {
    const char* name;
    GlTexture texture;
  };

  const GlFunctions& gl;
  const StackPlanes& planes;
  const ReliefPlanes flat{};
  const ReliefPlanes& relief;
  GlProgram program;
  std::array<Bound, 16> textures;
  std::optional<GlTarget> target;
  GLuint vertex_array = 0;

  State(const GlContext& context, const StackPlanes& stack, const std::string& fragment_shader,
        const ReliefPlanes* heights)
      : gl(context.functions()),
        planes(stack),
        relief(heights ? *heights : flat),
        program(gl, reference_vertex_shader(context.language()), fragment_shader),
        textures{{{"patch_plane", upload(gl, kRg16ui, stack.patch_plane)},
                  {"contents", upload(gl, kRgba32i, stack.contents)},
                  {"base", upload(gl, kRgba32f, stack.base)},
                  {"masks", upload(gl, kRgba16ui, stack.masks)},
                  {"noise_tiles", upload(gl, kRgba32f, stack.noise_tiles)},
                  {"fragment_plane", upload(gl, kRgba16i, stack.fragment_plane)},
                  {"local_mean", upload(gl, kRgba32f, stack.local_mean)},
                  {"scale_table", upload(gl, kRgba32i, stack.scale_table)},
                  {"color_table", upload(gl, kRgba32f, stack.color_table)},
                  {"level_blocks", upload(gl, kRg32ui, stack.level_blocks)},
                  {"level_entries", upload(gl, kRg16ui, stack.level_entries)},
                  {"base_levels", upload(gl, kRgba32f, stack.base_levels)},
                  {"level_weights", upload(gl, kRgba16ui, stack.level_weights)},
                  {"fragment_shares", upload(gl, kRgba32i, stack.fragment_shares)},
                  {"height_plane", upload(gl, kRgba32f, relief.height_plane)},
                  {"height_levels", upload(gl, kRgba32f, relief.height_levels)}}} {
    gl.GenVertexArrays(1, &vertex_array);
  }
  ~State() { gl.DeleteVertexArrays(1, &vertex_array); }

  void bind_textures() {
    int unit = 0;
    for (const Bound& bound : textures) {
      bound.texture.bind(unit);
      gl.Uniform1i(program.uniform(bound.name), unit++);
    }
  }

  /// The target's lowest line, read first, is the top row: row `first_row` of the view. `reference` is a repetition of
  /// the finest tile near what is drawn.
  void set_stack(uint32_t seed, glsl::uvec2 reference, const TileOffset& x, const TileOffset& y, int first_row) {
    const Nesting nesting = nesting_at(planes, reference);
    gl.Uniform1i(program.uniform("scale_count"), planes.scale_count());
    gl.Uniform1ui(program.uniform("stack_seed"), seed);
    gl.Uniform2i(program.uniform("noise_log2"), planes.noise_log2.x, planes.noise_log2.y);
    gl.Uniform1i(program.uniform("finest_noise_step"), planes.noise_step);
    gl.Uniform1i(program.uniform("noise_root"), planes.noise_root);
    gl.Uniform4uiv(program.uniform("nesting"), kMaxScales, &nesting.tiles[0].x);
    gl.Uniform2iv(program.uniform("nesting_offset"), kMaxScales, &nesting.offsets[0].x);
    gl.Uniform2ui(program.uniform("origin_tile"), x.tile, y.tile);
    gl.Uniform2i(program.uniform("origin_offset"), static_cast<GLint>(x.offset_256), static_cast<GLint>(y.offset_256));
    gl.Uniform2i(program.uniform("first_row"), first_row, 1);
  }

  void set_view(const Window& window, const ScaleView& view, const Direction& viewer) {
    const glsl::vec3 slant = slant_of(planes, viewer, window, view.scale);
    gl.Uniform3f(program.uniform("slant"), slant.x, slant.y, slant.z);
    gl.Uniform1ui(program.uniform("step_256"), window.step_256);
    gl.Uniform1i(program.uniform("filter_kind"), smooth_filter(window.filter));
    gl.Uniform1i(program.uniform("view_scale"), view.scale);
    gl.Uniform1i(program.uniform("level_256"), view.level_256);
    gl.Uniform1f(program.uniform("fading"), view.fading);
    gl.Uniform1f(program.uniform("variation"), view.variation);
  }

  void set_view(const Perspective& view) { set_perspective(gl, program, view, view.sky); }

  void set_relief() {
    const auto set = [&](const char* name, const glsl::vec4& v) {
      gl.Uniform4f(program.uniform(name), v.x, v.y, v.z, v.w);
    };
    set("relief_range", relief.range);
    set("relief_light", relief.light);
    gl.Uniform2i(program.uniform("relief_steps"), relief.steps.x, relief.steps.y);
    gl.Uniform1f(program.uniform("relief_depth"), relief.depth_px);
    gl.Uniform1i(program.uniform("relief_kind"), relief.kind);
  }

  /// Makes the target, the program and the textures current.
  void begin(int width, int height) {
    if (!target || target->width() != width || target->height() != height) target.emplace(gl, width, height);
    target->bind();
    gl.UseProgram(program.name());
    bind_textures();
  }

  void draw() {
    gl.BindVertexArray(vertex_array);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Finish();
  }
};

GlStackRenderer::GlStackRenderer(const GlContext& context, const StackPlanes& planes, const ReliefPlanes* relief)
    : GlStackRenderer(context, planes, stack_fragment_shader(context.language()), relief) {}

GlStackRenderer::GlStackRenderer(const GlContext& context, const StackPlanes& planes,
                                 const std::string& fragment_shader, const ReliefPlanes* relief)
    : state_(std::make_unique<State>(context, planes, fragment_shader, relief)) {}

GlStackRenderer::~GlStackRenderer() = default;

void GlStackRenderer::draw_only(const Window& window, const ScaleView& view, const Direction& viewer) {
  State& s = *state_;
  check_window(window, s.planes.sizes[static_cast<size_t>(view.scale)]);
  s.begin(window.width, window.height);
  s.set_stack(window.seed, reference_near(s.planes, window, view.scale), window.origin_x, window.origin_y, 0);
  s.set_view(window, view, viewer);
  s.set_relief();
  s.draw();
}

void GlStackRenderer::draw_only(const Perspective& view, int row_begin, int row_end) {
  State& s = *state_;
  check_perspective(view, s.planes.sizes.back());
  s.begin(view.width, row_end - row_begin);
  s.set_stack(view.seed, {view.origin_x.tile, view.origin_y.tile}, view.origin_x, view.origin_y, row_begin);
  s.set_view(view);
  s.set_relief();
  s.draw();
}

Frame GlStackRenderer::read() const {
  const GlTarget& target = *state_->target;
  Frame frame{Image<glsl::vec4>(target.width(), target.height(), {0, 0, 0, 0}),
              Image<PixelDecision>(target.width(), target.height())};
  target.read_values(frame.values.data());
  target.read_decisions(frame.decisions.data());
  return frame;
}

Frame GlStackRenderer::draw(const Window& window, const ScaleView& view, const Direction& viewer) {
  draw_only(window, view, viewer);
  return read();
}

Frame GlStackRenderer::draw(const Perspective& view, int row_begin, int row_end) {
  draw_only(view, row_begin, row_end);
  return read();
}

}  // namespace texbake
