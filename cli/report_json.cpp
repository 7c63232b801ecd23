#include "cli/report_json.h"

#include <cmath>

namespace texbake {
namespace {

Json json_of(const Measured& measured) {
  if (!measured.value) return {{"notDefined", measured.undefined_because}};
  return {{"mean", measured.value->mean}, {"spread", measured.value->spread}};
}

Json limits_json(const Limits& limits) {
  Json json = Json::object();
  if (std::isfinite(limits.pass_low)) json["min"] = limits.pass_low;
  if (std::isfinite(limits.pass_high)) json["max"] = limits.pass_high;
  return json;
}

bool is_known(const Measured& measured) { return measured.value || !measured.undefined_because.empty(); }

Json measure_json(const Report& report, const MeasureKind& kind) {
  Json json = {
      {"key", kind.key}, {"group", kind.group}, {"label", kind.label}, {"unit", kind.unit}, {"meaning", kind.meaning}};
  for (const Judgement& judgement : report.judgements) {
    if (judgement.measure != kind.measure) continue;
    json["verdict"] = enum_name(judgement.verdict);
    json["good"] = limits_json(judgement.limits);
    json["advice"] = kind.advice;
  }
  for (const auto& [method, name] : EnumNames<Method>::values) {
    const Measured& measured = report.of(method)[kind.measure];
    if (is_known(measured)) json[std::string(name)] = json_of(measured);
  }
  if (is_known(report.floor[kind.measure])) json["floor"] = json_of(report.floor[kind.measure]);
  return json;
}

}  // namespace

Json report_json(const Report& report, const std::string& bundle, const std::string& page) {
  Json json = {{"bundle", bundle}};
  if (!page.empty()) json["page"] = page;
  json["verdict"] = report.is_suitable() ? Json(enum_name(report.verdict)) : Json("unsuitable");
  if (!report.suitability.fits())
    json["suitability"] = {{"because", report.suitability.because}, {"helps", report.suitability.helps}};
  json["tile"] = {report.tile_px.x, report.tile_px.y};
  json["patches"] = report.patch_count;
  json["contents"] = report.content_count;
  json["measured"] = {{"reduction", report.reduction},
                      {"seamReduction", report.seam_reduction},
                      {"seeds", report.options.seeds},
                      {"tiles", report.options.tiles}};
  Json maps = Json::array();
  for (const MapReport& map : report.maps)
    maps.push_back(
        {{"name", map.name}, {"tileX", map.tile_x}, {"tileY", map.tile_y}, {"verdict", enum_name(map.verdict)}});
  json["maps"] = maps;
  Json measures = Json::array();
  for (const MeasureKind& kind : measure_kinds())
    if (is_known(report.of(Method::bundle)[kind.measure])) measures.push_back(measure_json(report, kind));
  json["measures"] = measures;
  return json;
}

}  // namespace texbake
