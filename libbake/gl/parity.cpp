#include "libbake/gl/parity.h"

#include <algorithm>

#include "libbake/base/random.h"

namespace texbake {
namespace {

/// A repetition of the tile where arithmetic could go wrong, or any.
uint32_t telling_tile(Random& random) {
  const uint32_t near = random.below(5) - 2u;  // −2 … 2
  switch (random.below(4)) {
    case 0:
      return near;
    case 1:
      return 0x80000000u + near;
    case 2:
      return 0xfffffff0u + random.below(16);
    default:
      return random.next();
  }
}

TileOffset telling_origin(Random& random, int side) {
  return {telling_tile(random), random.below(static_cast<uint32_t>(side) * 256)};
}

}  // namespace

std::vector<Window> parity_windows(V2i tile_size, const ParityOptions& options) {
  Random random(options.seed, 17);
  std::vector<Window> windows;
  for (int i = 0; i < options.windows; ++i) {
    Window window;
    window.origin_x = telling_origin(random, tile_size.x);
    window.origin_y = telling_origin(random, tile_size.y);
    window.step_256 = 16 + random.below(i % 4 == 0 ? 240 : 2032);
    window.width = window.height = options.side;
    window.seed = random.next();
    window.filter = i % 2 == 0 ? Filter::bilinear : Filter::nearest;
    if (i % 4 == 2) {
      window.filter = Filter::trilinear;
      window.step_256 <<= random.below(8);
    }
    windows.push_back(window);
  }
  return windows;
}

void count_contents(const Frame& frame, int content_count, std::vector<bool>& seen) {
  for (const PixelDecision& decision : frame.decisions) {
    const size_t at = size_t{decision.patch_idx} * static_cast<size_t>(content_count) + decision.content;
    if (at < seen.size()) seen[at] = true;
  }
}

void add_frames(ParityReport& report, const Window& window, const std::string& plane, const Frame& expected,
                const Frame& found) {
  const ValueComparison values = compare_values(color_values(expected.values), color_values(found.values), 0);
  const DecisionComparison decisions = compare_decisions(expected.decisions, found.decisions);
  report.points += values.pixels;
  report.differing_points += std::max(values.differing_pixels, uint64_t{values.differing_bits > 0});
  report.differing_bits += values.differing_bits;
  report.nan_points += values.nan_pixels;
  report.differing_decisions += decisions.differing_pixels;
  if (values.worst && (!report.worst || values.worst->difference > report.worst->pixel.difference))
    report.worst = WorstWindow{window, plane, *values.worst};
  if (decisions.differing_pixels == 0 || report.first_decision) return;
  const V2i at = decisions.first;
  report.first_decision = DifferingDecision{window, at, expected.decisions(at.x, at.y), found.decisions(at.x, at.y)};
}

ParityReport check_parity(const EvaluatorPlanes& planes, const GlContext& context, const ParityOptions& options) {
  GlRenderer renderer(context, planes);
  ParityReport report;
  report.driver = context.description();
  std::vector<bool> seen(static_cast<size_t>(planes.patch_count) * static_cast<size_t>(planes.content_count), false);
  report.contents = seen.size();
  const auto all_seen = [&] { return std::find(seen.begin(), seen.end(), false) == seen.end(); };
  const auto check = [&](const Window& window, const Plane& plane) {
    const Frame expected = reference_frame(planes, window, plane);
    count_contents(expected, planes.content_count, seen);
    add_frames(report, window, plane.name, expected, renderer.draw(window, plane));
  };
  ParityOptions longest = options;
  longest.windows = std::max(options.windows, options.most_windows);
  int drawn = 0;
  for (const Window& window : parity_windows(planes.size, longest)) {
    if (drawn++ >= options.windows && all_seen()) break;
    check(window, planes.base);
    for (const Plane& map : planes.maps) check(window, map);
  }
  report.drawn_contents = static_cast<uint64_t>(std::count(seen.begin(), seen.end(), true));
  return report;
}

}  // namespace texbake
