#include "libbake/draw/drawing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "libbake/base/error.h"
#include "libbake/base/suggestion.h"
#include "libbake/draw/perspective.h"
#include "libbake/draw/relief_window.h"
#include "libbake/draw/stack_perspective.h"
#include "libbake/draw/stack_window.h"
#include "libbake/draw/supersample.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/prepare_stack.h"

namespace texbake {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::usage, what); }

bool shows_color(const DrawRequest& request) { return request.map.empty() && request.show == Show::color; }

/// Whether all scales are drawn together. A map, and how the texture is put together, is that of the finest.
bool draws_stack(const DrawnMaterial& material, const DrawRequest& request) {
  return shows_color(request) && (material.scales.size() > 1 || request.has_relief());
}

/// The finest scale with the map that is drawn alone: the others need no levels of detail.
EvaluatorInput drawn_input(const EvaluatorInput& finest, const std::string& map) {
  EvaluatorInput input = finest;
  std::erase_if(input.maps, [&](const MapInput& one) { return one.name != map; });
  if (map.empty() || !input.maps.empty()) return input;
  std::vector<std::string> known;
  for (const MapInput& one : finest.maps) known.push_back(one.name);
  refuse(
      fmt::format("--map: no map \"{}\"{}; {}", map, suggestion(map, known),
                  known.empty() ? "the bundle has no maps" : fmt::format("the bundle has {}", fmt::join(known, ", "))));
}

}  // namespace

int DrawRequest::width() const {
  return std::visit([](const auto& one) { return one.width; }, view);
}
int DrawRequest::height() const {
  return std::visit([](const auto& one) { return one.height; }, view);
}
bool DrawRequest::is_deformed() const { return is_flat() && !std::get<Window>(view).deformation.is_identity(); }

Features DrawRequest::features() const {
  Features all;
  all.add(Feature::deformation, is_deformed());
  all.add(Feature::map, !map.empty());
  all.add(Feature::show, show != Show::color);
  all.add(Feature::plane, !is_flat());
  all.add(Feature::supersample, samples > 1);
  all.add(Feature::relief, has_relief());
  return all;
}

int drawn_channels(const DrawnMaterial& material, const DrawRequest& request) {
  if (request.map.empty()) return 3;
  return static_cast<int>(drawn_input(material.finest, request.map).maps.front().channels.size());
}

Drawing::Drawing(const DrawnMaterial& material, const DrawRequest& request) : request_(request) {
  Features features = request.features();
  features.add(Feature::scales, material.scales.size() > 1);
  check_features(features);
  check_show(material.finest, request.show);
  if (!draws_stack(material, request)) {
    EvaluatorInput input = drawn_input(material.finest, request.map);
    input.grain_apart = request.is_deformed();
    tile_ = prepare(input);
    plane_ = request.map.empty() ? &tile_.base : &tile_.maps.front();
    return;
  }
  stack_ = prepare_stack(material.scales);
  if (request.has_relief())
    relief_ = relief_planes(material.scales.front().input, request.relief.options, request.relief.light);
}

Image<V3f> Drawing::rows(int row_begin, int row_end) const {
  return std::visit(
      [&](const auto& view) {
        return plane_ ? tile_rows(view, row_begin, row_end) : stack_rows(view, row_begin, row_end);
      },
      request_.view);
}

Image<V3f> Drawing::tile_rows(const Window& window, int row_begin, int row_end) const {
  if (request_.samples > 1) return supersampled_rows(tile_, *plane_, window, request_.samples, row_begin, row_end);
  if (plane_ == &tile_.base) return show_rows(tile_, window, request_.show, row_begin, row_end);
  return render_map_rows(tile_, *plane_, window, row_begin, row_end);
}

Image<V3f> Drawing::tile_rows(const Perspective& view, int row_begin, int row_end) const {
  if (request_.samples > 1)
    return supersampled_perspective_rows(tile_, *plane_, view, request_.samples, row_begin, row_end);
  return render_perspective_rows(tile_, *plane_, view, row_begin, row_end);
}

Image<V3f> Drawing::stack_rows(const Window& window, int row_begin, int row_end) const {
  if (request_.samples > 1)
    return supersampled_stack_rows(stack_, relief(), request_.relief.viewer, window, request_.samples, row_begin,
                                   row_end);
  if (relief_) return render_relief_rows(stack_, *relief_, request_.relief.viewer, window, row_begin, row_end);
  return render_stack_rows(stack_, window, row_begin, row_end);
}

Image<V3f> Drawing::stack_rows(const Perspective& view, int row_begin, int row_end) const {
  if (request_.samples > 1)
    return supersampled_stack_perspective_rows(stack_, relief(), view, request_.samples, row_begin, row_end);
  return render_stack_perspective_rows(stack_, relief(), view, row_begin, row_end);
}

}  // namespace texbake
