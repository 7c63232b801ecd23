#include "cli/verify_gl.h"

#include "formats/json_text.h"
#include "libbake/draw/window_part.h"

namespace texbake {
namespace {

const char* full_name(GlLanguage language) { return language == GlLanguage::es ? "OpenGL ES 3.0" : "OpenGL 3.3 core"; }

/// A point of the infinite texture.
struct Place {
  V2i tile_size;
  const Window& window;
  V2i pixel;

  WindowPoint point() const { return point_of(window, tile_size, pixel); }
  static double texel(const TileOffset& at) { return at.offset_256 / 256.0; }
};

std::string text(const Place& place) {
  const auto [x, y] = place.point();
  return fmt::format("tile ({}, {}), texel ({}, {}), seed {}, {}", x.tile, y.tile, Place::texel(x), Place::texel(y),
                     place.window.seed, enum_name(place.window.filter));
}

Json json_of(const Place& place) {
  const auto [x, y] = place.point();
  return {{"tile", {x.tile, y.tile}},
          {"texel", {Place::texel(x), Place::texel(y)}},
          {"seed", place.window.seed},
          {"filter", enum_name(place.window.filter)}};
}

std::string text(const PixelDecision& decision) {
  return fmt::format("patch {} content {} source ({}, {})", decision.patch_idx, decision.content, decision.source_x,
                     decision.source_y);
}

Json json_of(const PixelDecision& decision) {
  return {
      {"patch", decision.patch_idx}, {"content", decision.content}, {"source", {decision.source_x, decision.source_y}}};
}

std::string text(const PerspectiveParity& parity, const char* where) {
  if (parity.pixels == 0) return {};
  return fmt::format("  {} pixels {}: {} see another point (at most {} may), {} values differ\n", parity.pixels, where,
                     parity.differing_sights,
                     static_cast<uint64_t>(PerspectiveParity::kTolerance * static_cast<double>(parity.pixels)),
                     parity.differing_values);
}

Json json_of(const PerspectiveParity& parity) {
  return {{"pixels", parity.pixels},
          {"differingSights", parity.differing_sights},
          {"differingValues", parity.differing_values}};
}

std::string text(const LanguageParity& found, V2i tile_size) {
  const MaterialParity& parity = found.parity;
  const ParityReport& report = parity.report;
  std::string out = fmt::format("{} on {}: {}\n", full_name(found.language), report.driver,
                                parity.equal() ? "equals the processor" : "differs from the processor");
  out += fmt::format("  {} points, {} of {} contents: {} decisions, {} points and {} bits differ, {} points are NaN\n",
                     report.points, report.drawn_contents, report.contents, report.differing_decisions,
                     report.differing_points, report.differing_bits, report.nan_points);
  out += text(parity.perspective, "in perspective") + text(parity.relief, "of windows with relief");
  if (const auto& first = report.first_decision)
    out += fmt::format("  first decision: {}: expected {}, found {}\n",
                       text(Place{tile_size, first->window, first->pixel}), text(first->expected), text(first->found));
  if (const auto& worst = report.worst)
    out += fmt::format("  worst value: {} at {}: expected {}, found {}\n", worst->plane,
                       text(Place{tile_size, worst->window, {worst->pixel.x, worst->pixel.y}}),
                       vector_text(worst->pixel.expected), vector_text(worst->pixel.found));
  return out;
}

Json json_of(const LanguageParity& found, V2i tile_size) {
  const MaterialParity& parity = found.parity;
  const ParityReport& report = parity.report;
  Json json = {{"language", enum_name(found.language)},
               {"driver", report.driver},
               {"equal", parity.equal()},
               {"points", report.points},
               {"contents", report.contents},
               {"drawnContents", report.drawn_contents},
               {"differingDecisions", report.differing_decisions},
               {"differingPoints", report.differing_points},
               {"differingBits", report.differing_bits},
               {"nanPoints", report.nan_points},
               {"perspective", json_of(parity.perspective)},
               {"relief", json_of(parity.relief)}};
  if (const auto& first = report.first_decision) {
    json["firstDecision"] = json_of(Place{tile_size, first->window, first->pixel});
    json["firstDecision"].update({{"expected", json_of(first->expected)}, {"found", json_of(first->found)}});
  }
  if (const auto& worst = report.worst) {
    json["worst"] = json_of(Place{tile_size, worst->window, {worst->pixel.x, worst->pixel.y}});
    json["worst"].update({{"plane", worst->plane},
                          {"expected", vector_json(worst->pixel.expected)},
                          {"found", vector_json(worst->pixel.found)}});
  }
  return json;
}

}  // namespace

Outcome parity_outcome(const std::vector<LanguageParity>& languages, V2i tile_size) {
  Outcome outcome;
  Json list = Json::array();
  for (const LanguageParity& found : languages) {
    if (!found.parity.equal()) outcome.code = ExitCode::no;
    outcome.text += text(found, tile_size);
    list.push_back(json_of(found, tile_size));
  }
  outcome.result["gl"] = list;
  return outcome;
}

}  // namespace texbake
