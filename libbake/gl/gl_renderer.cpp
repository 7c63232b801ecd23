#include "libbake/gl/gl_renderer.h"

#include <map>
#include <optional>

#include "libbake/draw/view_program.h"
#include "libbake/draw/window_program.h"
#include "libbake/gl/gl_objects.h"
#include "libbake/gl/gl_view.h"

namespace texbake {
namespace {

/// Texture units, in the order of shaders/bindings.glsl.
enum Unit {
  kPatchPlane,
  kContents,
  kCenters,
  kBase,
  kMasks,
  kNoiseTiles,
  kLevelTable,
  kLevelBlocks,
  kLevelEntries,
  kLevelWeights,
  kBaseLevels
};

/// One texel of zeros stands for what a bundle lacks.
template <class T>
GlTexture upload(const GlFunctions& gl, const GlFormat& format, const Image<T>& image) {
  constexpr uint32_t kZeros[4] = {};
  if (image.empty()) return GlTexture(gl, format, 1, 1, kZeros);
  return GlTexture(gl, format, image.width(), image.height(), image.data());
}

}  // namespace

struct GlRenderer::State {
  const GlFunctions& gl;
  const EvaluatorPlanes& planes;
  GlProgram program;
  GlTexture patch_plane, contents, centers, masks, noise_tiles, level_table, level_blocks, level_entries, level_weights;
  std::map<const Plane*, std::pair<GlTexture, GlTexture>> values;  ///< texels and levels, uploaded when first drawn
  std::optional<GlTarget> target;
  GLuint vertex_array = 0;

  State(const GlContext& context, const EvaluatorPlanes& prepared, const std::string& fragment_shader)
      : gl(context.functions()),
        planes(prepared),
        program(gl, reference_vertex_shader(context.language()), fragment_shader),
        patch_plane(upload(gl, kRg16ui, planes.patch_plane)),
        contents(upload(gl, kRgba32i, planes.contents)),
        centers(upload(gl, kRgba32i, planes.centers)),
        masks(upload(gl, kRgba16ui, planes.masks)),
        noise_tiles(upload(gl, kRgba32f, planes.noise_tiles)),
        level_table(upload(gl, kRgba32i, planes.level_table)),
        level_blocks(upload(gl, kRg32ui, planes.level_blocks)),
        level_entries(upload(gl, kRg16ui, planes.level_entries)),
        level_weights(upload(gl, kRgba16ui, planes.level_weights)) {
    gl.GenVertexArrays(1, &vertex_array);
  }
  ~State() { gl.DeleteVertexArrays(1, &vertex_array); }

  const std::pair<GlTexture, GlTexture>& textures_of(const Plane& plane) {
    const auto found = values.find(&plane);
    if (found != values.end()) return found->second;
    return values.try_emplace(&plane, upload(gl, kRgba32f, plane.texels), upload(gl, kRgba32f, plane.level_values))
        .first->second;
  }

  void bind_textures(const Plane& plane) {
    const auto& [texels, levels] = textures_of(plane);  // first: an upload binds
    patch_plane.bind(kPatchPlane);
    contents.bind(kContents);
    centers.bind(kCenters);
    texels.bind(kBase);
    masks.bind(kMasks);
    noise_tiles.bind(kNoiseTiles);
    levels.bind(kBaseLevels);
    level_table.bind(kLevelTable);
    level_blocks.bind(kLevelBlocks);
    level_entries.bind(kLevelEntries);
    level_weights.bind(kLevelWeights);
    gl.Uniform1i(program.uniform("patch_plane"), kPatchPlane);
    gl.Uniform1i(program.uniform("contents"), kContents);
    gl.Uniform1i(program.uniform("centers"), kCenters);
    gl.Uniform1i(program.uniform("base"), kBase);
    gl.Uniform1i(program.uniform("masks"), kMasks);
    gl.Uniform1i(program.uniform("noise_tiles"), kNoiseTiles);
    gl.Uniform1i(program.uniform("base_levels"), kBaseLevels);
    gl.Uniform1i(program.uniform("level_table"), kLevelTable);
    gl.Uniform1i(program.uniform("level_blocks"), kLevelBlocks);
    gl.Uniform1i(program.uniform("level_entries"), kLevelEntries);
    gl.Uniform1i(program.uniform("level_weights"), kLevelWeights);
  }

  void set_deformation(const Window& window, bool is_base) {
    const glsl::Program bound = program_of(planes, window);
    const auto set4 = [&](const char* name, const glsl::ivec4& v) {
      gl.Uniform4i(program.uniform(name), v.x, v.y, v.z, v.w);
    };
    gl.Uniform1i(program.uniform("deformed"), is_base && !window.deformation.is_identity() ? 1 : 0);
    set4("deform_matrix", bound.deform_matrix);
    gl.Uniform2ui(program.uniform("deform_from_tile"), bound.deform_from_tile.x, bound.deform_from_tile.y);
    gl.Uniform2i(program.uniform("deform_from"), bound.deform_from.x, bound.deform_from.y);
    gl.Uniform2ui(program.uniform("deform_to_tile"), bound.deform_to_tile.x, bound.deform_to_tile.y);
    set4("deform_to", bound.deform_to);
    gl.Uniform2i(program.uniform("turbulence"), bound.turbulence.x, bound.turbulence.y);
  }

  /// The target's lowest line, read first, is the top row: row `first_row` of the view.
  void set_tile(MapKind kind, uint32_t seed, int first_row) {
    gl.Uniform2i(program.uniform("tile_size"), planes.size.x, planes.size.y);
    gl.Uniform2i(program.uniform("noise_log2"), planes.noise_log2.x, planes.noise_log2.y);
    gl.Uniform1i(program.uniform("noise_step"), planes.noise_step);
    gl.Uniform1i(program.uniform("noise_root"), planes.noise_root);
    gl.Uniform1ui(program.uniform("content_count"), static_cast<GLuint>(planes.content_count));
    gl.Uniform1ui(program.uniform("seed"), seed);
    gl.Uniform1i(program.uniform("level_count"), planes.level_count);
    gl.Uniform1i(program.uniform("first_level"), planes.first_level);
    gl.Uniform2i(program.uniform("first_row"), first_row, 1);
    gl.Uniform1i(program.uniform("plane_kind"), plane_kind(kind));
  }

  void set_origin(const TileOffset& x, const TileOffset& y) {
    gl.Uniform2ui(program.uniform("origin_tile"), x.tile, y.tile);
    gl.Uniform2i(program.uniform("origin_offset"), static_cast<GLint>(x.offset_256), static_cast<GLint>(y.offset_256));
  }

  void set_view(const Window& window) {
    gl.Uniform1ui(program.uniform("step_256"), window.step_256);
    gl.Uniform1i(program.uniform("filter_kind"), window.filter == Filter::nearest ? 0 : 1);
    gl.Uniform1i(program.uniform("level_256"), level_256_of(window, planes.level_count));
  }

  void set_view(const Perspective& view, const V3f& sky) { set_perspective(gl, program, view, sky); }

  /// Makes the target, the program and the textures current.
  void begin(int width, int height, const Plane& plane) {
    if (!target || target->width() != width || target->height() != height) target.emplace(gl, width, height);
    target->bind();
    gl.UseProgram(program.name());
    bind_textures(plane);
  }

  void draw() {
    gl.BindVertexArray(vertex_array);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Finish();
  }
};

GlRenderer::GlRenderer(const GlContext& context, const EvaluatorPlanes& planes)
    : GlRenderer(context, planes, reference_fragment_shader(context.language())) {}

GlRenderer::GlRenderer(const GlContext& context, const EvaluatorPlanes& planes, const std::string& fragment_shader)
    : state_(std::make_unique<State>(context, planes, fragment_shader)) {}

GlRenderer::~GlRenderer() = default;

void GlRenderer::draw_only(const Window& window, const Plane& plane) {
  State& s = *state_;
  check_window(window, s.planes.size);
  s.begin(window.width, window.height, plane);
  s.set_tile(plane.kind, window.seed, 0);
  s.set_origin(window.origin_x, window.origin_y);
  s.set_deformation(window, &plane == &s.planes.base);
  s.set_view(window);
  s.draw();
}

void GlRenderer::draw_only(const Perspective& view, const Plane& plane, int row_begin, int row_end) {
  State& s = *state_;
  check_perspective(view, s.planes.size);
  s.begin(view.width, row_end - row_begin, plane);
  s.set_tile(plane.kind, view.seed, row_begin);
  s.gl.Uniform1i(s.program.uniform("deformed"), 0);
  s.set_origin(view.origin_x, view.origin_y);
  s.set_view(view, &plane == &s.planes.base ? view.sky : V3f(0));
  s.draw();
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

}  // namespace texbake
