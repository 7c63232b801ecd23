#include "libbake/gl/gl_renderer.h"

#include <map>
#include <optional>

#include "libbake/eval/program_of.h"
#include "libbake/gl/gl_objects.h"

namespace texbake {
namespace {

/// Texture units, in the order of shaders/bindings.glsl.
enum Unit { kPatchPlane, kContents, kCenters, kBase, kMasks, kNoiseTiles };

int plane_kind(MapKind kind) {
  switch (kind) {
    case MapKind::normal_opengl:
      return 1;
    case MapKind::normal_directx:
      return 2;
    case MapKind::height:
      return 3;
    case MapKind::structure:
      return 4;
    case MapKind::plain:
      break;
  }
  return 0;
}

template <class T>
GlTexture upload(const GlFunctions& gl, const GlFormat& format, const Image<T>& image) {
  return GlTexture(gl, format, image.width(), image.height(), image.data());
}

}  // namespace

struct GlRenderer::State {
  const GlFunctions& gl;
  const EvaluatorPlanes& planes;
  GlProgram program;
  GlTexture patch_plane, contents, centers, masks, noise_tiles;
  std::map<const Plane*, GlTexture> values;  ///< uploaded when first drawn
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
        noise_tiles(upload(gl, kRgba32f, planes.noise_tiles)) {
    gl.GenVertexArrays(1, &vertex_array);
  }
  ~State() { gl.DeleteVertexArrays(1, &vertex_array); }

  const GlTexture& texture_of(const Plane& plane) {
    const auto found = values.find(&plane);
    if (found != values.end()) return found->second;
    const Image<glsl::vec4>& texels = plane.texels;
    return values.try_emplace(&plane, gl, kRgba32f, texels.width(), texels.height(), texels.data()).first->second;
  }

  void bind_textures(const Plane& plane) {
    const GlTexture& drawn = texture_of(plane);  // first: an upload binds
    patch_plane.bind(kPatchPlane);
    contents.bind(kContents);
    centers.bind(kCenters);
    drawn.bind(kBase);
    masks.bind(kMasks);
    noise_tiles.bind(kNoiseTiles);
    gl.Uniform1i(program.uniform("patch_plane"), kPatchPlane);
    gl.Uniform1i(program.uniform("contents"), kContents);
    gl.Uniform1i(program.uniform("centers"), kCenters);
    gl.Uniform1i(program.uniform("base"), kBase);
    gl.Uniform1i(program.uniform("masks"), kMasks);
    gl.Uniform1i(program.uniform("noise_tiles"), kNoiseTiles);
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

  void set_uniforms(const Window& window, const Plane& plane) {
    gl.Uniform2i(program.uniform("tile_size"), planes.size.x, planes.size.y);
    gl.Uniform1i(program.uniform("noise_size"), planes.noise_size);
    gl.Uniform1ui(program.uniform("content_count"), static_cast<GLuint>(planes.content_count));
    gl.Uniform1ui(program.uniform("seed"), window.seed);
    set_deformation(window, &plane == &planes.base);
    gl.Uniform2ui(program.uniform("origin_tile"), window.origin_x.tile, window.origin_y.tile);
    gl.Uniform2i(program.uniform("origin_offset"), static_cast<GLint>(window.origin_x.offset_256),
                 static_cast<GLint>(window.origin_y.offset_256));
    gl.Uniform1ui(program.uniform("step_256"), window.step_256);
    gl.Uniform2i(program.uniform("first_row"), 0, 1);  // the lowest line, read first, is the top row
    gl.Uniform1i(program.uniform("filter_kind"), window.filter == Filter::bilinear ? 1 : 0);
    gl.Uniform1i(program.uniform("plane_kind"), plane_kind(plane.kind));
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
  if (!s.target || s.target->width() != window.width || s.target->height() != window.height)
    s.target.emplace(s.gl, window.width, window.height);
  s.target->bind();
  s.gl.UseProgram(s.program.name());
  s.bind_textures(plane);
  s.set_uniforms(window, plane);
  s.gl.BindVertexArray(s.vertex_array);
  s.gl.DrawArrays(GL_TRIANGLES, 0, 3);
  s.gl.Finish();
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

}  // namespace texbake
