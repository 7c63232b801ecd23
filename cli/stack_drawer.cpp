#include "cli/stack_drawer.h"

#include <memory>

#include "formats/evaluator_input.h"
#include "libbake/draw/relief_window.h"
#include "libbake/draw/stack_perspective.h"
#include "libbake/draw/supersample.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/stack_levels.h"

namespace texbake {
namespace {

/// What a drawer keeps.
struct Stack {
  std::vector<StackScale> scales;
  StackPlanes planes;

  explicit Stack(const Bundle& bundle) : scales(stack_input(bundle)), planes(prepare_stack(scales)) {}
};

/// What a drawer on OpenGL keeps.
std::shared_ptr<const void> both(const std::shared_ptr<Stack>& stack,
                                 const std::shared_ptr<const ReliefPlanes>& relief) {
  return std::make_shared<std::pair<std::shared_ptr<Stack>, std::shared_ptr<const ReliefPlanes>>>(stack, relief);
}

DrawRows flat_drawer(const Bundle& bundle, const StackPicture& picture, const std::shared_ptr<Stack>& stack) {
  const Window window = window_of(picture.window, picture.size, stack->planes.sizes.back());
  const int samples = picture.view.supersample;
  if (samples > 1)
    return [stack, window, samples](int begin, int end) {
      return supersampled_stack_rows(stack->planes, window, samples, begin, end);
    };
  if (needs_levels(window) || has_relief(picture.relief)) add_levels(stack->planes, stack->scales);
  const auto relief = relief_of(bundle.scales.front(), picture.relief, picture.slant);
  const Direction viewer = parse_direction("view-direction", picture.slant.view);
  if (picture.gl.backend == Backend::gl)
    return gl_stack_row_drawer(stack->planes, relief.get(), viewer, window, picture.gl.gl_device, both(stack, relief));
  if (relief)
    return [stack, relief, viewer, window](int begin, int end) {
      return render_relief_rows(stack->planes, *relief, viewer, window, begin, end);
    };
  return [stack, window](int begin, int end) { return render_stack_rows(stack->planes, window, begin, end); };
}

DrawRows plane_drawer(const Bundle& bundle, const StackPicture& picture, const std::shared_ptr<Stack>& stack) {
  const Perspective view = perspective_of(picture.view, picture.window, picture.size, stack->planes.sizes.back());
  const int samples = picture.view.supersample;
  add_levels(stack->planes, stack->scales);
  const auto relief = relief_of(bundle.scales.front(), picture.relief, picture.slant);
  if (samples > 1)
    return [stack, relief, view, samples](int begin, int end) {
      return supersampled_stack_perspective_rows(stack->planes, relief.get(), view, samples, begin, end);
    };
  if (picture.gl.backend == Backend::gl)
    return gl_stack_row_drawer(stack->planes, relief.get(), view, picture.gl.gl_device, both(stack, relief));
  return [stack, relief, view](int begin, int end) {
    return render_stack_perspective_rows(stack->planes, relief.get(), view, begin, end);
  };
}

}  // namespace

std::shared_ptr<const ReliefPlanes> relief_of(const Scale& coarsest, const ReliefOptions& options,
                                              const SlantOptions& slant) {
  if (!has_relief(options)) return nullptr;
  return std::make_shared<ReliefPlanes>(
      relief_planes(evaluator_input(coarsest), options, parse_direction("light", slant.light)));
}

DrawRows stack_drawer(const Bundle& bundle, const StackPicture& picture) {
  const auto stack = std::make_shared<Stack>(bundle);
  if (picture.view.view == View::plane) return plane_drawer(bundle, picture, stack);
  return flat_drawer(bundle, picture, stack);
}

}  // namespace texbake
