#include "cli/info_json.h"

#include <fmt/format.h>

#include "formats/json_text.h"
#include "formats/transfer.h"

namespace texbake {
namespace {

/// The fields of a scale that are present, in the order of the design's list of words.
class FieldList {
 public:
  explicit FieldList(const Scale& scale) : tile_(fmt::format("{}x{}", scale.width(), scale.height_px())) {}
  void add(const std::string& name, const std::string& shape, const char* unit, const char* what) {
    list_.push_back({{"name", name}, {"shape", shape}, {"unit", unit}, {"what", what}});
  }
  void add_plane(const std::string& name, const char* rest, const char* unit, const char* what) {
    add(name, tile_ + rest, unit, what);
  }
  Json take() { return std::move(list_); }

 private:
  std::string tile_;
  Json list_ = Json::array();
};

void add_color_fields(const Scale& scale, FieldList& fields) {
  const char* form = scale.stores_exemplar ? "what is tiled and drawn" : "decoded from index and variation";
  fields.add_plane("exemplar", "x3 half", "linear Rec.709 light", form);
  if (scale.structure) fields.add_plane("structure", "x3 half", "linear Rec.709 light", "the base: exemplar - noise");
  if (!scale.masks.empty())
    fields.add_plane("masks", fmt::format("x{} half", scale.masks.size()).c_str(), "0 to 1, sum 1",
                     "weight of each noise");
  if (!scale.colors) return;
  fields.add("palette", fmt::format("{}x(3+3) float", scale.colors->palette.classes.size()), "CIELUV (D65)",
             "dominant colors and principal variations");
  fields.add_plane("index", " uint", "class", "color class of each texel");
  fields.add_plane("variation", " half", "ΔE", "coordinate along the principal variation");
}

void add_shape_fields(const Scale& scale, FieldList& fields) {
  if (scale.fragments) {
    const int count = scale.fragments->partition.count();
    fields.add_plane("fragment", " uint + owner offset", "fragment", "fragment of each texel");
    fields.add("fragments", fmt::format("{}", count), "texels, linear light", "center, area, class, mean color");
  }
  if (scale.patches) {
    fields.add_plane("patch", " uint + owner offset", "patch", "patch of each texel");
    fields.add("patches", fmt::format("{}", scale.patches->partition.count()), "texels", "center and area");
  }
  if (scale.contents)
    fields.add("contents", fmt::format("{}x{}", scale.contents->patch_count, scale.contents->content_count),
               "texels, ΔE⁴", "translation, rotation, scale, impact; the first is the identity");
  if (scale.soft_border_px > 0)
    fields.add("softBorder", fmt::format("{}", scale.soft_border_px), "texels",
               "width over which patches blend, on either side");
}

void add_map_fields(const Scale& scale, FieldList& fields) {
  if (scale.height) fields.add_plane("height", " float", "0 to 1", "relief");
  for (const Map& map : scale.maps) {
    const char* type = map.source_bits > 8 ? "float" : "half";
    const std::string shape = fmt::format("{} {}", map.channels == 3 ? "x3" : "", type);
    const char* unit = map.convention.empty() ? "as in the file" : "unit vector";
    fields.add_plane("map " + map.name, shape.c_str(), unit,
                     map.convention == "opengl"    ? "normal, +y up"
                     : map.convention == "directx" ? "normal, +y down"
                                                   : "another picture of the same surface");
  }
}

void add_noise_fields(const NoiseModel& model, FieldList& fields) {
  size_t lobes = 0;
  for (size_t k = 0; k < model.noises.size(); ++k) {
    const Noise& noise = model.noises[k];
    const std::string number = fmt::format(" {}", k);
    fields.add("spectrum" + number, fmt::format("{0}x{0}x3 float", noise.spectrum_size()), "magnitude, light",
               "of each channel of the noise");
    fields.add("noise tile" + number, fmt::format("{}x{}x3 half", noise.tile.width(), noise.tile.height()),
               "linear Rec.709 light", "values of the noise, row by row");
    for (const NoiseChannel& channel : noise.channels) lobes += channel.lobes.lobes.size();
  }
  fields.add("noise lattice", fmt::format("(x + {} y) mod {}", model.lattice.row_step, model.lattice.count),
             "index of a value", "which value of the noises a texel shows");
  fields.add("color bases", fmt::format("{}x(3+3x3) float", model.noises.size()), "linear Rec.709 light",
             "mean and axes of the noises' colors");
  fields.add("histograms", fmt::format("{}x{} float", 3 * model.noises.size(), Equalization::kEntries), "light",
             "transfer of each channel, -4 to 4 standard deviations");
  fields.add("lobes", fmt::format("{}", lobes), "cycles per texel", "compact spectra, if accurate enough");
}

Json fields_json(const Scale& scale, const NoiseModel* noise) {
  FieldList fields(scale);
  add_color_fields(scale, fields);
  if (noise) add_noise_fields(*noise, fields);
  add_shape_fields(scale, fields);
  add_map_fields(scale, fields);
  return fields.take();
}

Json palette_json(const Scale& scale) {
  Json palette = Json::array();
  if (scale.colors)
    for (const ColorClass& color : scale.colors->palette.classes)
      palette.push_back({{"dominant", vector_json(color.dominant)}, {"variation", vector_json(color.variation)}});
  return palette;
}

Json scale_json(const Scale& scale, const NoiseModel* noise) {
  Json json = {{"name", scale.name}, {"width", scale.width()}, {"height", scale.height_px()}};
  if (scale.tile_from_source)
    json["tileFromSource"] = Json::array({scale.tile_from_source->x, scale.tile_from_source->y});
  if (scale.transfer) json["transfer"] = transfer_json(*scale.transfer);
  json["fields"] = fields_json(scale, noise);
  json["palette"] = palette_json(scale);
  return json;
}

std::string scale_text(const Json& scale) {
  std::string text = fmt::format("scale {}: {} x {} texels\n", scale["name"].get<std::string>(),
                                 scale["width"].get<int>(), scale["height"].get<int>());
  if (scale.contains("transfer"))
    text += fmt::format("  takes colors from the scale before: {}\n", compact_json(scale["transfer"]));
  for (const Json& field : scale["fields"])
    text +=
        fmt::format("  {:<16} {:<32} {:<22} {}\n", field["name"].get<std::string>(), field["shape"].get<std::string>(),
                    field["unit"].get<std::string>(), field["what"].get<std::string>());
  return text;
}

/// " of scale NAME" for a source or a stage of one scale among several.
std::string of_scale(const Json& json) {
  return json.contains("scale") ? fmt::format(" of scale {}", json["scale"].get<std::string>()) : "";
}

std::string stage_text(const Json& stage) {
  std::string text = fmt::format("stage {}{}\n", stage["verb"].get<std::string>(), of_scale(stage));
  for (const auto& [name, value] : stage["parameters"].items()) text += fmt::format("  {} = {}\n", name, value.dump());
  for (const auto& [name, value] : stage["figures"].items()) text += fmt::format("  {}: {}\n", name, value.dump());
  return text;
}

}  // namespace

Json info_json(const Bundle& bundle) {
  Json info = {{"version", kBundleVersion}, {"semantics", bundle.semantics}};
  for (const Scale& scale : bundle.scales) {
    const bool has_noise = bundle.noise && &scale == &bundle.scales.back();
    info["scales"].push_back(scale_json(scale, has_noise ? &*bundle.noise : nullptr));
  }
  const auto add = [&](const char* list, Json json, const std::string& scale) {
    if (!scale.empty()) json["scale"] = scale;
    info[list].push_back(std::move(json));
  };
  info["sources"] = Json::array();
  for (const SourceFile& source : bundle.sources)
    add("sources",
        {{"role", source.role}, {"name", source.name}, {"sha256", source.sha256}, {"sizeBytes", source.size_bytes}},
        source.scale);
  info["stages"] = Json::array();
  for (const Stage& stage : bundle.stages)
    add("stages",
        {{"verb", stage.verb},
         {"version", stage.version},
         {"parameters", stage.parameters},
         {"figures", stage.figures}},
        stage.scale);
  return info;
}

std::string info_text(const Json& info, const std::string& path) {
  std::string text = fmt::format("{}: bundle {}, semantics {}\n", path, info["version"].get<std::string>(),
                                 info["semantics"].get<int>());
  for (const Json& scale : info["scales"]) text += scale_text(scale);
  for (const Json& source : info["sources"])
    text += fmt::format("source {}{}: {}, {} bytes, SHA-256 {}\n", source["role"].get<std::string>(), of_scale(source),
                        source["name"].get<std::string>(), source["sizeBytes"].get<uint64_t>(),
                        source["sha256"].get<std::string>());
  for (const Json& stage : info["stages"]) text += stage_text(stage);
  return text;
}

}  // namespace texbake
