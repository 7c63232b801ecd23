#include "libbake/gl/gl_stack_renderer.h"

#include <array>
#include <optional>

#include "libbake/gl/gl_objects.h"

namespace texbake {
namespace {

/// One texel of zeros stands for levels that were not added.
template <class T>
GlTexture upload(const GlFunctions& gl, const GlFormat& format, const Image<T>& image) {
  constexpr uint32_t kZeros[4] = {};
  if (image.empty()) return GlTexture(gl, format, 1, 1, kZeros);
  return GlTexture(gl, format, image.width(), image.height(), image.data());
}

static_assert(sizeof(glsl::uvec4) == 16 && sizeof(glsl::ivec2) == 8 && sizeof(glsl::FragmentTexel) == 8 &&
                  sizeof(glsl::FragmentRange) == 8,
              "uniforms and texels are given to OpenGL as they lie in memory");

}  // namespace

struct GlStackRenderer::State {
  struct Bound {
    const char* name;
    GlTexture texture;
  };

  const GlFunctions& gl;
  const StackPlanes& planes;
  GlProgram program;
  std::array<Bound, 15> textures;
  std::optional<GlTarget> target;
  GLuint vertex_array = 0;

  State(const GlContext& context, const StackPlanes& stack)
      : gl(context.functions()),
        planes(stack),
        program(gl, reference_vertex_shader(context.language()), stack_fragment_shader(context.language())),
        textures{{{"patch_plane", upload(gl, kRg16ui, stack.patch_plane)},
                  {"contents", upload(gl, kRgba32i, stack.contents)},
                  {"centers", upload(gl, kRgba32i, stack.centers)},
                  {"base", upload(gl, kRgba32f, stack.base)},
                  {"fragment_plane", upload(gl, kRgba16i, stack.fragment_plane)},
                  {"local_mean", upload(gl, kRgba32f, stack.local_mean)},
                  {"scale_table", upload(gl, kRgba32i, stack.scale_table)},
                  {"class_table", upload(gl, kRgba32f, stack.class_table)},
                  {"mean_table", upload(gl, kRgba32f, stack.mean_table)},
                  {"level_table", upload(gl, kRgba32i, stack.level_table)},
                  {"level_blocks", upload(gl, kRg32ui, stack.level_blocks)},
                  {"level_entries", upload(gl, kRg16ui, stack.level_entries)},
                  {"base_levels", upload(gl, kRgba32f, stack.base_levels)},
                  {"fragment_ranges", upload(gl, kRg32ui, stack.fragment_ranges)},
                  {"fragment_shares", upload(gl, kRgba32i, stack.fragment_shares)}}} {
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

  void set_uniforms(const Window& window, const ScaleView& view) {
    const Nesting nesting = nesting_at(planes, reference_near(planes, window, view.scale));
    gl.Uniform1i(program.uniform("scale_count"), planes.scale_count());
    gl.Uniform1ui(program.uniform("stack_seed"), window.seed);
    gl.Uniform4uiv(program.uniform("nesting"), kMaxScales, &nesting.tiles[0].x);
    gl.Uniform2iv(program.uniform("nesting_offset"), kMaxScales, &nesting.offsets[0].x);
    gl.Uniform2ui(program.uniform("origin_tile"), window.origin_x.tile, window.origin_y.tile);
    gl.Uniform2i(program.uniform("origin_offset"), static_cast<GLint>(window.origin_x.offset_256),
                 static_cast<GLint>(window.origin_y.offset_256));
    gl.Uniform1ui(program.uniform("step_256"), window.step_256);
    gl.Uniform2i(program.uniform("first_row"), 0, 1);  // the lowest line, read first, is the top row
    gl.Uniform1i(program.uniform("filter_kind"), window.filter == Filter::nearest ? 0 : 1);
    gl.Uniform1i(program.uniform("view_scale"), view.scale);
    gl.Uniform1i(program.uniform("level_256"), view.level_256);
    gl.Uniform1f(program.uniform("fading"), view.fading);
    gl.Uniform1f(program.uniform("variation"), view.variation);
  }
};

GlStackRenderer::GlStackRenderer(const GlContext& context, const StackPlanes& planes)
    : state_(std::make_unique<State>(context, planes)) {}

GlStackRenderer::~GlStackRenderer() = default;

void GlStackRenderer::draw_only(const Window& window, const ScaleView& view) {
  State& s = *state_;
  check_window(window, s.planes.sizes[static_cast<size_t>(view.scale)]);
  if (!s.target || s.target->width() != window.width || s.target->height() != window.height)
    s.target.emplace(s.gl, window.width, window.height);
  s.target->bind();
  s.gl.UseProgram(s.program.name());
  s.bind_textures();
  s.set_uniforms(window, view);
  s.gl.BindVertexArray(s.vertex_array);
  s.gl.DrawArrays(GL_TRIANGLES, 0, 3);
  s.gl.Finish();
}

Frame GlStackRenderer::draw(const Window& window, const ScaleView& view) {
  draw_only(window, view);
  const GlTarget& target = *state_->target;
  Frame frame{Image<glsl::vec4>(target.width(), target.height(), {0, 0, 0, 0}),
              Image<PixelDecision>(target.width(), target.height())};
  target.read_values(frame.values.data());
  target.read_decisions(frame.decisions.data());
  return frame;
}

}  // namespace texbake
