#include "cli/window_options.h"

#include <cmath>
#include <vector>

#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

constexpr double kStepsPerTexel = 256;  // of Window::step_256

}  // namespace

Window window_of(const WindowOptions& options, PixelSize size, V2i tile_size) {
  const DecimalPoint origin = parse_point("origin", options.origin);
  Window window;
  window.origin_x = tile_offset(origin.x, tile_size.x, "origin");
  window.origin_y = tile_offset(origin.y, tile_size.y, "origin");
  window.step_256 = static_cast<uint32_t>(std::lround(options.step_texels * kStepsPerTexel));
  window.width = size.width;
  window.height = size.height;
  window.seed = options.seed;
  window.filter = options.filter;
  check_window(window, tile_size);
  return window;
}

const Plane& chosen_plane(const EvaluatorPlanes& planes, const std::optional<std::string>& name) {
  if (!name) return planes.base;
  if (const Plane* map = planes.map(*name)) return *map;
  std::vector<std::string> known;
  for (const Plane& map : planes.maps) known.push_back(map.name);
  const std::string list =
      known.empty() ? "the bundle has no maps" : fmt::format("the bundle has {}", fmt::join(known, ", "));
  throw Error(ErrorKind::usage, fmt::format("--map: no map \"{}\"{}; {}", *name, suggestion(*name, known), list));
}

PictureRole role_of(const EvaluatorPlanes& planes, const Plane& plane) {
  if (&plane == &planes.base) return PictureRole::color;
  const bool normal = plane.kind == MapKind::normal_opengl || plane.kind == MapKind::normal_directx;
  return normal ? PictureRole::normal : PictureRole::data;
}

}  // namespace texbake
