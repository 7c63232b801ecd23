// Draws windows with fragment shaders that other compilers made of the reference text, and compares them with the
// processor. Arguments: for one scale, for a stack. Exit code 1 for a bit that differs, 77 without OpenGL.
#include <fstream>
#include <iostream>
#include <sstream>

#include "libbake/gl/parity.h"
#include "libbake/gl/stack_parity.h"
#include "tests/libbake/draw/small_stack.h"
#include "tests/libbake/gl/gl_test_context.h"

namespace texbake {
namespace {

std::string text_of(const char* path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Of one scale with noise and soft borders, deformed in every second window.
ParityReport tile_report(const GlContext& context, const std::string& shader) {
  SmallTile tile = random_tile({65, 97}, 5, Contents::turned, 81);
  add_noise(tile, 3, 64, 81);
  tile.soft_border_px = 3;
  EvaluatorInput input = tile.input();
  input.grain_apart = true;
  const EvaluatorPlanes planes = prepare(input);
  GlRenderer renderer(context, planes, shader);
  ParityReport report;
  int i = 0;
  for (Window& window : parity_windows(planes.size, {.windows = 12, .side = 64, .seed = 81})) {
    if (i++ % 2 == 1)
      window.deformation = deformation_of({.rotate_degrees = 10.0 * i, .stretch_x = 3, .turbulence_texels = 9});
    add_frames(report, window, "base", reference_frame(planes, window, planes.base),
               renderer.draw(window, planes.base));
  }
  return report;
}

ParityReport stack_report(const GlContext& context, const std::string& shader) {
  const StackPlanes planes = two_scales({.ratio = 6}, Contents::turned).planes();
  GlRenderer renderer(context, planes, shader, nullptr);
  ParityReport report;
  const std::vector<ScaleView> views = parity_views(planes);
  const std::vector<Window> windows = parity_windows(planes.sizes.back(), {.windows = 12, .side = 32, .seed = 82});
  for (size_t i = 0; i < windows.size(); ++i) {
    const ScaleView& view = views[i % views.size()];
    const Window window = seen_from_afar(planes, windows[i], view.scale);
    add_frames(report, window, "stack", reference_stack_frame(planes, window, view), renderer.draw(window, view));
  }
  return report;
}

int run(const char* tile_shader, const char* stack_shader) {
  const auto context = test_context(ShaderLanguage::glsl_330);
  if (!context) return 77;
  bool equal = true;
  const auto tell = [&](const char* what, const ParityReport& report) {
    std::cout << what << ": " << report.points << " points, " << report.differing_decisions << " decisions and "
              << report.differing_bits << " bits differ\n";
    equal = equal && report.equal() && report.points > 0;
  };
  tell("one scale", tile_report(*context, text_of(tile_shader)));
  tell("stack", stack_report(*context, text_of(stack_shader)));
  return equal ? 0 : 1;
}

}  // namespace
}  // namespace texbake

int main(int argc, char** argv) { return argc == 3 ? texbake::run(argv[1], argv[2]) : 2; }
