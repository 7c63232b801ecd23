#include "formats/manifest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "formats/byte_text.h"
#include "formats/json_text.h"
#include "formats/noise_manifest.h"
#include "formats/plane_refs.h"
#include "formats/sha256.h"
#include "formats/transfer.h"

namespace texbake {
namespace {

constexpr const char* kGenerator = "texbake " TEXBAKE_VERSION;

Json json_of(V2i v) { return Json::array({v.x, v.y}); }

Json planes_json(const PlaneRefs& refs) {
  Json planes = Json::object();
  for (const PlaneRef& ref : refs)
    if (!ref.key.starts_with(kMapKey)) planes[ref.key] = plane_json(ref);
  return planes;
}

Json maps_json(const std::vector<Map>& maps, const PlaneRefs& refs) {
  Json list = Json::array();
  for (const Map& map : maps) {
    const auto ref = std::ranges::find(refs, kMapKey + map.name, &PlaneRef::key);
    list.push_back({{"name", map.name},
                    {"channels", map.channels},
                    {"sourceBits", map.source_bits},
                    {"sourceFloat", map.is_float},
                    {"convention", map.convention},
                    {"plane", plane_json(*ref)}});
  }
  return list;
}

Json palette_json(const Palette& palette) {
  Json list = Json::array();
  for (const ColorClass& color : palette.classes)
    list.push_back({{"dominant", vector_json(color.dominant)}, {"variation", vector_json(color.variation)}});
  return list;
}

Json patches_json(const Partition& patches) {
  Json list = Json::array();
  for (size_t i = 0; i < patches.centers.size(); ++i)
    list.push_back({{"center", json_of(patches.centers[i])}, {"areaPx", patches.areas_px[i]}});
  return list;
}

Json contents_json(const ContentTable& table) {
  Json patches = Json::array();
  for (int p = 0; p < table.patch_count; ++p) {
    Json list = Json::array();
    for (int c = 0; c < table.content_count; ++c) {
      const Content& content = table.at(p, c);
      list.push_back({{"translation", json_of(content.translation)},
                      {"rotationEighths", content.rotation_eighths},
                      {"scale", json_number(content.scale)},
                      {"matrix", json_of(V2i(content.a, content.b))},
                      {"impact", json_number(content.impact)}});
    }
    patches.push_back(std::move(list));
  }
  return patches;
}

Json scale_json(const Scale& scale, const PlaneRefs& refs) {
  Json json = {{"name", scale.name}, {"size", json_of(scale.size())}};
  if (scale.tile_from_source) json["tileFromSource"] = json_of(*scale.tile_from_source);
  json["planes"] = planes_json(refs);
  if (!scale.maps.empty()) json["maps"] = maps_json(scale.maps, refs);
  json["mean"] = vector_json(mean_color(scale.base()));
  if (scale.colors) json["palette"] = palette_json(scale.colors->palette);
  if (scale.fragments) json["fragments"] = {{"count", scale.fragments->fragments.size()}};
  if (scale.patches) json["patches"] = patches_json(scale.patches->partition);
  if (scale.contents) json["contents"] = contents_json(*scale.contents);
  if (scale.soft_border_px > 0) json["softBorder"] = scale.soft_border_px;
  if (scale.transfer) json["transfer"] = transfer_json(*scale.transfer);
  return json;
}

Json object_or_empty(const Json& json) { return json.is_null() ? Json::object() : json; }

Json stage_json(const Stage& stage) {
  Json json = {{"verb", stage.verb},
               {"version", stage.version},
               {"parameters", object_or_empty(stage.parameters)},
               {"figures", object_or_empty(stage.figures)},
               {"input", stage.input},
               {"output", stage.output}};
  if (!stage.scale.empty()) json["scale"] = stage.scale;
  return json;
}

Json source_json(const SourceFile& source) {
  Json json = {{"role", source.role},
               {"name", text_of_bytes(source.name)},
               {"sha256", source.sha256},
               {"sizeBytes", source.size_bytes}};
  if (!source.scale.empty()) json["scale"] = source.scale;
  return json;
}

}  // namespace

BundleRefs plane_refs(const Bundle& bundle) {
  BundleRefs refs;
  for (const Scale& scale : bundle.scales) refs.scales.push_back(hash_planes(planes_of(scale), scale.name));
  if (bundle.noise) refs.noise = noise_refs(*bundle.noise);
  return refs;
}

StateJson state_json(const Bundle& bundle, const BundleRefs& refs) {
  StateJson state{Json::array(), {}};
  for (size_t i = 0; i < refs.scales.size(); ++i) state.scales.push_back(scale_json(bundle.scales[i], refs.scales[i]));
  if (bundle.noise) state.noise = noise_json(*bundle.noise, refs.noise);
  return state;
}

Json manifest_json(const Bundle& bundle, const StateJson& state) {
  Json json = {{"asset",
                {{"kind", "texbake.bundle"},
                 {"version", kBundleVersion},
                 {"minVersion", kBundleVersion},
                 {"semantics", kSemantics}}},
               {"generator", kGenerator},
               {"scales", state.scales}};
  if (!state.noise.is_null()) json["noise"] = state.noise;
  json["sources"] = Json::array();
  for (const SourceFile& source : bundle.sources) json["sources"].push_back(source_json(source));
  json["stages"] = Json::array();
  for (const Stage& stage : bundle.stages) json["stages"].push_back(stage_json(stage));
  if (!bundle.extensions.empty()) json["extensions"] = bundle.extensions;
  if (!bundle.extras.empty()) json["extras"] = bundle.extras;
  for (const auto& [key, value] : bundle.unknown.items())
    if (!json.contains(key)) json[key] = value;
  return json;
}

}  // namespace texbake
