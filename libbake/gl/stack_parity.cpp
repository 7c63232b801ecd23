#include "libbake/gl/stack_parity.h"

#include <algorithm>

namespace texbake {

std::vector<ScaleView> parity_views(const StackPlanes& planes) {
  std::vector<ScaleView> views;
  for (int scale = planes.finest(); scale >= 0; --scale) {
    views.push_back({scale, 0, 1});
    if (scale > 0) views.push_back({scale, 0.3f, 0.4f});
    if (scale > 0) views.push_back({scale, 0.7f, 0});
    const int levels = planes.level_count(scale);
    for (int level = 1; level <= levels; ++level) {
      const bool fades = scale > 0;
      const float fading = fades ? static_cast<float>(level) / static_cast<float>(levels + 1) : 0;
      views.push_back({scale, fading, fades ? 0.5f : 1, level == levels ? level * 256 : level * 256 + 100});
    }
  }
  return views;
}

Window seen_from_afar(const StackPlanes& planes, const Window& window, int scale) {
  Window far = window;
  far.step_256 *= static_cast<uint32_t>(planes.texels_in(scale));
  return far;
}

ParityReport check_stack_parity(const StackPlanes& planes, const GlContext& context, const ParityOptions& options) {
  GlRenderer renderer(context, planes);
  ParityReport report;
  report.driver = context.description();
  std::vector<std::vector<bool>> seen;
  for (size_t s = 0; s < planes.sizes.size(); ++s)
    seen.emplace_back(static_cast<size_t>(planes.patch_counts[s]) * static_cast<size_t>(planes.content_counts[s]),
                      false);
  const auto all_seen = [&] {
    return std::all_of(seen.begin(), seen.end(), [](const std::vector<bool>& scale) {
      return std::find(scale.begin(), scale.end(), false) == scale.end();
    });
  };
  ParityOptions longest = options;
  longest.windows = std::max(options.windows, options.most_windows);
  const std::vector<Window> windows = parity_windows(planes.sizes.back(), longest);
  const std::vector<ScaleView> views = parity_views(planes);
  for (int i = 0; i < longest.windows && (i < options.windows || !all_seen()); ++i) {
    const ScaleView& view = views[static_cast<size_t>(i) % views.size()];
    const auto scale = static_cast<size_t>(view.scale);
    const Window window = seen_from_afar(planes, windows[static_cast<size_t>(i)], view.scale);
    const Frame expected = reference_stack_frame(planes, window, view);
    count_contents(expected, planes.content_counts[scale], seen[scale]);
    add_frames(report, window, "stack", expected, renderer.draw(window, view));
  }
  for (const std::vector<bool>& scale : seen) {
    report.contents += scale.size();
    report.drawn_contents += static_cast<uint64_t>(std::count(scale.begin(), scale.end(), true));
  }
  return report;
}

}  // namespace texbake
