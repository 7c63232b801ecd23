#include "libbake/gl/perspective_parity.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "libbake/draw/stack_perspective.h"
#include "libbake/gl/stack_parity.h"

namespace texbake {
namespace {

constexpr int kWidth = 192, kHeight = 128;

/// From above a brick to a view of the horizon, at origins where arithmetic could go wrong.
std::vector<Perspective> telling_views() {
  constexpr double kHeights[] = {20, 300, 5000};
  constexpr double kPitches[] = {90, 35, 8};
  constexpr uint32_t kTiles[] = {0, 0xffffffffu, 0x80000000u};
  constexpr Filter kFilters[] = {Filter::anisotropic, Filter::trilinear, Filter::bilinear, Filter::nearest};
  std::vector<Perspective> views;
  for (size_t i = 0; i < 9; ++i) {
    Perspective view;
    view.height_texels = kHeights[i % 3];
    view.pitch_deg = kPitches[i / 3];
    view.yaw_deg = 37.0 * static_cast<double>(i);
    view.origin_x = {kTiles[i % 3], 77};
    view.origin_y = {kTiles[i / 3], 1};
    view.width = kWidth;
    view.height = kHeight;
    view.seed = static_cast<uint32_t>(i);
    view.filter = kFilters[i < 6 ? 0 : i - 5];
    views.push_back(view);
  }
  return views;
}

void add(PerspectiveParity& parity, const Frame& expected, const Frame& found) {
  parity.pixels += expected.values.size();
  for (size_t i = 0; i < expected.values.size(); ++i) {
    if (expected.decisions.data()[i] != found.decisions.data()[i])
      ++parity.differing_sights;
    else if (std::memcmp(expected.values.data() + i, found.values.data() + i, sizeof(glsl::vec4)) != 0)
      ++parity.differing_values;
  }
}

}  // namespace

PerspectiveParity check_perspective_parity(const EvaluatorPlanes& planes, const GlContext& context) {
  GlRenderer renderer(context, planes, perspective_fragment_shader(context.language()));
  PerspectiveParity parity;
  for (const Perspective& view : telling_views()) {
    add(parity, perspective_frame(planes, planes.base, view), renderer.draw(view, planes.base));
    for (const Plane& map : planes.maps) add(parity, perspective_frame(planes, map, view), renderer.draw(view, map));
  }
  return parity;
}

PerspectiveParity check_stack_perspective_parity(const StackPlanes& planes, const ReliefPlanes* relief,
                                                 const GlContext& context) {
  GlRenderer renderer(context, planes, stack_perspective_fragment_shader(context.language()), relief);
  PerspectiveParity parity;
  const std::vector<Perspective> views = telling_views();
  for (size_t i = 0; i < views.size(); ++i) {
    Perspective view = views[i];
    const int scale = static_cast<int>(i / 2) % planes.scale_count();
    view.height_texels = std::min(1e6, view.height_texels * static_cast<double>(planes.texels_in(scale)));
    add(parity, stack_perspective_frame(planes, relief, view), renderer.draw(view, 0, view.height));
  }
  return parity;
}

PerspectiveParity check_relief_parity(const StackPlanes& planes, const ReliefPlanes& relief, const GlContext& context) {
  constexpr Direction kViewers[] = {{1, -0.5f, 0.75f}, {-3, 2, 1}, {0, 0, 1}};
  GlRenderer renderer(context, planes, &relief);
  PerspectiveParity parity;
  const std::vector<ScaleView> views = parity_views(planes);
  for (size_t i = 0; i < views.size(); ++i) {
    const ParityOptions options{.windows = 4, .seed = static_cast<uint32_t>(i)};
    Window window = seen_from_afar(planes, parity_windows(planes.sizes.back(), options)[i % 4], views[i].scale);
    window.width = kWidth;
    window.height = kHeight;
    const Direction& viewer = kViewers[i % 3];
    add(parity, relief_frame(planes, relief, viewer, window, views[i]), renderer.draw(window, views[i], viewer));
  }
  return parity;
}

}  // namespace texbake
