#include "libbake/gl/gl_drawing.h"

#include <fmt/format.h>

#include "libbake/base/error.h"
#include "libbake/draw/compare.h"
#include "libbake/gl/gl_rows.h"

namespace texbake {
namespace {

std::string shader_of(const Drawing& drawing) {
  const ShaderLanguage language = ShaderLanguage::glsl_330;
  if (drawing.plane())
    return drawing.request().is_flat() ? reference_fragment_shader(language) : perspective_fragment_shader(language);
  return drawing.request().is_flat() ? stack_fragment_shader(language) : stack_perspective_fragment_shader(language);
}

}  // namespace

/// A renderer is destroyed before the context that it draws on.
struct GlDrawing::State {
  const Drawing& drawing;
  GlContext context;
  std::optional<GlRenderer> renderer;

  State(const Drawing& drawn, const std::optional<int>& device)
      : drawing(drawn), context({ShaderLanguage::glsl_330, device}) {
    if (drawing.plane())
      renderer.emplace(context, drawing.tile(), shader_of(drawing));
    else
      renderer.emplace(context, drawing.stack(), shader_of(drawing), drawing.relief());
  }

  Image<V3f> rows(const Window& window, int begin, int end) {
    if (const Plane* plane = drawing.plane()) return gl_rows(*renderer, drawing.tile(), *plane, window, begin, end);
    return gl_rows(*renderer, drawing.stack(), drawing.request().relief.viewer, window, begin, end);
  }
  Image<V3f> rows(const Perspective& view, int begin, int end) {
    const Plane* plane = drawing.plane();
    return color_values((plane ? renderer->draw(view, *plane, begin, end) : renderer->draw(view, begin, end)).values);
  }
};

void check_gl_request(const DrawRequest& request) {
  if (request.show != Show::color)
    throw Error(ErrorKind::usage,
                fmt::format("--show {}: the reference shader draws only color and maps; use --backend cpu",
                            enum_name(request.show)));
  if (request.samples > 1)
    throw Error(ErrorKind::usage, "--supersample: available on the processor only; use --backend cpu");
}

GlDrawing::GlDrawing(const Drawing& drawing, const std::optional<int>& device) {
  check_gl_request(drawing.request());
  state_ = std::make_unique<State>(drawing, device);
}

GlDrawing::~GlDrawing() = default;

Image<V3f> GlDrawing::rows(int row_begin, int row_end) {
  return std::visit([&](const auto& view) { return state_->rows(view, row_begin, row_end); },
                    state_->drawing.request().view);
}

}  // namespace texbake
