#include "bake/bake_request.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "bake/option_json.h"
#include "bake/provenance.h"
#include "formats/bundle_io.h"
#include "formats/byte_text.h"
#include "formats/input_file.h"
#include "formats/sha256.h"
#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecipeVersion = "1.0";

/// What `request` asks of each stage, by verb.
Json asked_stages(const BakeRequest& request) {
  Json stages = Json::object();
  for_each_stage_options(request, [&](const std::string& verb, const auto& options) {
    if (!stages.contains(verb)) stages[verb] = Json::object();
    stages[verb].update(json_of(options));
  });
  return stages;
}

/// Everything that a recipe may ask for.
Json known_stages() {
  BakeRequest request;
  request.layers.layers = Layers::structure_noise;
  return asked_stages(request);
}

/// The stages of structure + noise that `stages` has, of all of them.
struct LayerStages {
  std::vector<std::string> all, there;
};
LayerStages layer_stages(const Json& stages) {
  LayerStages layers;
  for (const StageRow& row : stage_table())
    if (row.use == StageUse::layers) {
      layers.all.push_back(row.verb);
      if (stages.contains(row.verb)) layers.there.push_back(row.verb);
    }
  return layers;
}

/// The same from the record of a bundle; empty for a bundle that bake did not make.
Json asked_stages(const Bundle& bundle) {
  Json stages = Json::object();
  for (const Stage& stage : bundle.stages) stages[stage.verb] = asked_parameters(stage.parameters);
  return stages;
}

/// The sources of `request` as they are on the disk now.
std::vector<SourceFile> current_sources(const BakeRequest& request) {
  std::vector<SourceFile> sources;
  const auto add = [&](const MaterialFile& file) {
    check_input_file(file.file);
    sources.push_back({file.name, fs::path(file.file).filename().string(), sha256_file(file.file), 0});
  };
  add(request.convert.files.color);
  for (const MaterialFile& map : request.convert.files.maps) add(map);
  return sources;
}

bool same_sources(const std::vector<SourceFile>& a, const std::vector<SourceFile>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const SourceFile& x, const SourceFile& y) {
    return x.role == y.role && x.name == y.name && x.sha256 == y.sha256;
  });
}

Json file_json(const SourceFile& source) {
  return {{"name", source.role}, {"file", source.name}, {"sha256", source.sha256}};
}

Json parsed_file(const std::string& path) {
  check_input_file(path);
  return parse_json(file_bytes(path), path);
}

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::bad_data, fmt::format("{}: {}", where, why));
}

void check_kind(const Json& recipe, const std::string& path) {
  if (!recipe.is_object() || !recipe.contains("asset") || !recipe["asset"].is_object() ||
      recipe["asset"].value("kind", Json()) != kRecipeKind)
    refuse(path, "expected a recipe (\"asset\": {\"kind\": \"texbake.recipe\"}); \"texbake info --recipe\" writes one");
  const Json version = recipe["asset"].value("version", Json());
  if (version != kRecipeVersion)
    throw Error(ErrorKind::unsupported,
                fmt::format("{}: expected recipe version {}, found {}", path, kRecipeVersion, version.dump()));
}

/// Throws Error(bad_data) for a member that is not `known`.
void check_members(const Json& json, const std::vector<std::string>& known, const std::string& where) {
  for (const auto& [name, value] : json.items())
    if (std::ranges::find(known, name) == known.end())
      refuse(where, fmt::format("unknown member \"{}\"{}", name, suggestion(name, known)));
}

MaterialFile material_file(const Json& json, const fs::path& folder, const std::string& where) {
  if (json.is_object()) check_members(json, {"name", "file", "sha256"}, where);
  const auto text = [&](const char* key, bool required) {
    const Json value = json.is_object() ? json.value(key, Json()) : Json();
    if (!value.is_string() && (required || !value.is_null()))
      refuse(where, fmt::format("expected a string \"{}\"", key));
    return value.is_string() ? value.get<std::string>() : std::string();
  };
  const std::string name = text("name", true);
  if (!is_plane_name(name))
    refuse(where, fmt::format("expected a name of at most {} letters, digits, '-' and '_' that begins with a letter, "
                              "found \"{}\"",
                              kMaxPlaneNameLength, name));
  return {name, (folder / bytes_of_text(text("file", true))).string(), text("sha256", false)};
}

void read_files(const Json& recipe, const std::string& path, MaterialFiles& files) {
  const Json list = recipe.value("files", Json());
  if (!list.is_array() || list.empty()) refuse(path, "expected \"files\", a list that begins with the color");
  const fs::path folder = fs::path(path).parent_path();
  files.color = material_file(list[0], folder, path + ": files[0]");
  if (files.color.name != "color") refuse(path + ": files[0]", "expected the name \"color\"");
  for (size_t i = 1; i < list.size(); ++i)
    files.maps.push_back(material_file(list[i], folder, fmt::format("{}: files[{}]", path, i)));
}

}  // namespace

std::vector<const StageRow*> stages_for(const LayerOptions& layers) {
  std::vector<const StageRow*> stages;
  for (const StageRow& row : stage_table())
    if (row.use == StageUse::always || (row.use == StageUse::layers && layers.layers == Layers::structure_noise))
      stages.push_back(&row);
  return stages;
}

void check_request(const BakeRequest& request) {
  for_each_stage_options(request, [](const std::string&, const auto& options) { check_options(options); });
  if (request.layers.layers == Layers::structure_noise && request.convert.storage.color == ColorForm::palette)
    throw Error(ErrorKind::usage,
                "--layers structure+noise: expected --color full, found palette, which does not store the noise");
}

bool is_recipe(const std::string& path) { return fs::path(path).extension() == kRecipeExtension; }

Json recipe_of(const Bundle& bundle) {
  const Json stages = asked_stages(bundle), known = known_stages();
  LayerOptions layers;
  if (!layer_stages(stages).there.empty()) layers.layers = Layers::structure_noise;
  for (const StageRow* row : stages_for(layers))
    if (!stages.contains(row->verb))
      refuse("recipe", fmt::format("expected a bundle that bake can make again, but it has no stage {}", row->verb));
  for (const auto& [verb, parameters] : stages.items())
    if (!known.contains(verb)) refuse("recipe", fmt::format("the stage {} is not part of bake", verb));
  Json recipe;
  recipe["asset"] = {{"kind", kRecipeKind}, {"version", kRecipeVersion}};
  recipe["files"] = Json::array();
  for (const SourceFile& source : bundle.sources) recipe["files"].push_back(file_json(source));
  recipe["stages"] = stages;
  return recipe;
}

BakeRequest read_recipe(const std::string& path) {
  const Json recipe = parsed_file(path);
  check_kind(recipe, path);
  check_members(recipe, {"$schema", "asset", "files", "stages"}, path);
  BakeRequest request;
  read_files(recipe, path, request.convert.files);
  const Json stages = recipe.value("stages", Json::object());
  if (!stages.is_object()) refuse(path, "expected \"stages\" to be an object");

  // A stage may have several structs of options: every member belongs to one of them.
  std::map<std::string, JsonReader> readers;
  for (const auto& [verb, parameters] : stages.items())
    readers.emplace(verb, JsonReader(parameters, fmt::format("{}: stages.{}", path, verb)));
  const Json known = known_stages();
  const LayerStages layers = layer_stages(stages);
  if (!layers.there.empty() && layers.there.size() < layers.all.size())
    refuse(path, fmt::format("stages: expected both {}, or neither", fmt::join(layers.all, " and ")));
  if (!layers.there.empty()) request.layers.layers = Layers::structure_noise;
  for (const auto& [verb, reader] : readers)
    if (!known.contains(verb)) refuse(path, fmt::format("stages: \"{}\" is not a stage of bake", verb));
  for_each_stage_options(request, [&](const std::string& verb, auto& options) {
    const auto reader = readers.find(verb);
    if (reader != readers.end()) reader->second.read(options);
  });
  for (const auto& [verb, reader] : readers) reader.finish();
  return request;
}

bool is_up_to_date(const std::string& path, const BakeRequest& request) {
  const std::vector<SourceFile> sources = current_sources(request);
  std::error_code failed;
  if (!fs::exists(path, failed)) return false;
  IssueLog log(path, IssueLog::OnError::collect);
  const LoadedBundle loaded = load_bundle(path, {}, log);
  if (log.error_count() > 0) return false;
  return loaded.manifest.value("generator", "") == "texbake " TEXBAKE_VERSION &&
         same_sources(loaded.bundle.sources, sources) && asked_stages(loaded.bundle) == asked_stages(request);
}

}  // namespace texbake
