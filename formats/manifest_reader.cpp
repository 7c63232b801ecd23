#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "formats/asset.h"
#include "formats/byte_text.h"
#include "formats/json_text.h"
#include "formats/limits.h"
#include "formats/manifest.h"
#include "formats/noise_manifest.h"
#include "formats/plane_refs.h"
#include "formats/schema.h"
#include "formats/transfer.h"
#include "libbake/planes/prepare.h"

namespace texbake {
namespace {

V2i texel_of(const Json& json) { return {json[0].get<int>(), json[1].get<int>()}; }

/// Reads one scale; the schema has vouched for every member's shape.
class ScaleReader {
 public:
  ScaleReader(const Json& json, std::string pointer, Manifest& manifest, IssueLog& log)
      : json_(json), pointer_(std::move(pointer)), manifest_(manifest), log_(log) {}

  void read() {
    warn_unknown_members(json_, pointer_,
                         {"name", "size", "tiling", "tileFromSource", "planes", "maps", "mean", "palette", "fragments",
                          "patches", "contents", "softBorder", "transfer"},
                         log_);
    scale_.name = json_["name"];
    size_ = texel_of(json_["size"]);
    if (json_.contains("tiling") && json_["tiling"] != 1)
      issue(IssueId::tiling_unknown, "/tiling", fmt::format("expected 1, found {}", compact_json(json_["tiling"])));
    if (json_.contains("tileFromSource")) scale_.tile_from_source = texel_of(json_["tileFromSource"]);
    if (json_.contains("transfer")) scale_.transfer = transfer_of(json_["transfer"]);
    scale_.stores_exemplar = has("exemplar");
    check_companions();
    read_palette();
    read_fragments();
    read_patches();
    read_contents();
    read_soft_border();
    read_planes();
    read_maps();
    check_payload_name(scale_.name, refs_, pointer_ + "/planes", log_);
    if (log_.error_below(pointer_)) refs_.clear();
    manifest_.bundle.scales.push_back(std::move(scale_));
    manifest_.sizes.push_back(size_);
    manifest_.fragment_counts.push_back(fragment_count_);
    manifest_.refs.push_back(std::move(refs_));
  }

 private:
  void issue(IssueId id, const std::string& below, const std::string& detail) {
    log_.add({id, {.pointer = pointer_ + below}, detail});
  }
  bool has(const char* plane) const { return json_["planes"].contains(plane); }

  /// Planes and tables come together: a missing one is named once, for the first that needs it.
  void check_companions() {
    const auto need = [&](bool present, const char* what, const char* by, bool needed) {
      if (needed && !present)
        issue(IssueId::plane_missing, "", fmt::format("expected {} because there is {}, found none", what, by));
    };
    const bool palette = json_.contains("palette"), fragments = json_.contains("fragments"),
               patches = json_.contains("patches"), contents = json_.contains("contents");
    need(palette, "palette", "no plane exemplar", !scale_.stores_exemplar);
    need(has(kMasksKey), "plane masks", "plane structure", has("structure"));
    need(has("structure"), "plane structure", "plane masks", has(kMasksKey));
    need(has("index"), "plane index", "palette", palette);
    need(has("variation"), "plane variation", "palette", palette);
    need(palette, "palette", "plane index or variation", has("index") || has("variation"));
    for (const char* plane : {"fragment", "fragmentClass", "fragmentColor"}) {
      need(has(plane), fmt::format("plane {}", plane).c_str(), "fragments", fragments);
      need(fragments, "fragments", fmt::format("plane {}", plane).c_str(), has(plane));
    }
    need(palette, "palette", "fragments", fragments);
    need(has("patch"), "plane patch", "patches", patches);
    need(patches, "patches", "plane patch", has("patch"));
    need(fragments, "fragments", "patches", patches);
    need(patches, "patches", "contents", contents);
  }

  void read_palette() {
    if (!json_.contains("palette")) return;
    PrincipalVariation& colors = scale_.colors.emplace();
    for (const Json& color : json_["palette"])
      colors.palette.classes.push_back({vector_of(color["dominant"]), vector_of(color["variation"])});
  }

  void read_fragments() {
    if (!json_.contains("fragments")) return;
    const auto count = json_["fragments"]["count"].get<size_t>();
    if (!fits(count, "/fragments/count", "fragments")) return;
    scale_.fragments.emplace();
    fragment_count_ = count;
  }

  /// Every fragment and patch has a texel.
  bool fits(size_t count, const char* below, const char* what) {
    const size_t texels = static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y);
    if (count <= texels) return true;
    issue(IssueId::count_mismatch, below, fmt::format("expected at most {} {}, found {}", texels, what, count));
    return false;
  }

  void read_patches() {
    if (!json_.contains("patches") || !fits(json_["patches"].size(), "/patches", "patches")) return;
    Partition& partition = scale_.patches.emplace().partition;
    for (const Json& patch : json_["patches"]) {
      partition.centers.push_back(texel_of(patch["center"]));
      partition.areas_px.push_back(patch["areaPx"].get<uint32_t>());
    }
  }

  void read_soft_border() {
    if (!json_.contains("softBorder")) return;
    scale_.soft_border_px = json_["softBorder"];
    const int widest = max_soft_border_px(size_);
    if (!json_.contains("patches") || scale_.soft_border_px > widest)
      issue(IssueId::soft_border_width, "/softBorder",
            fmt::format("expected patches, and at most {} texels on a tile of {} x {}, found {}", widest, size_.x,
                        size_.y, scale_.soft_border_px));
  }

  void read_contents() {
    if (!json_.contains("contents")) return;
    const Json& patches = json_["contents"];
    ContentTable& table = scale_.contents.emplace();
    table.patch_count = static_cast<int>(patches.size());
    table.content_count = static_cast<int>(patches[0].size());
    if (scale_.patches && scale_.patches->partition.count() != table.patch_count)
      issue(IssueId::count_mismatch, "/contents",
            fmt::format("expected {} patches, found {}", scale_.patches->partition.count(), table.patch_count));
    for (size_t p = 0; p < patches.size(); ++p) {
      if (patches[p].size() != patches[0].size())
        issue(IssueId::count_mismatch, fmt::format("/contents/{}", p),
              fmt::format("expected {} contents as for patch 0, found {}", patches[0].size(), patches[p].size()));
      for (const Json& content : patches[p]) table.contents.push_back(content_of(content));
    }
  }

  static Content content_of(const Json& json) {
    const V2i matrix = texel_of(json["matrix"]);
    return {.translation = texel_of(json["translation"]),
            .a = matrix.x,
            .b = matrix.y,
            .rotation_eighths = json["rotationEighths"].get<int>(),
            .scale = json["scale"].get<float>(),
            .impact = json["impact"].get<float>()};
  }

  void read_planes() {
    static const std::set<std::string> known = {"preview",       "exemplar",  "structure", kMasksKey,
                                                "index",         "variation", "fragment",  "fragmentClass",
                                                "fragmentColor", "patch",     "height"};
    warn_unknown_members(json_["planes"], pointer_ + "/planes", known, log_);
    for (const auto& [key, plane] : json_["planes"].items()) {
      const bool is_table = key == "fragmentClass" || key == "fragmentColor";
      if (key == kMasksKey) scale_.masks.resize(plane["channels"].size());
      if (key == "structure") scale_.structure.emplace();
      if (key == "height") scale_.height.emplace();
      if (known.contains(key))
        add_ref(key, plane, "/planes/" + key, is_table ? table_size(fragment_count_, size_) : size_);
    }
  }

  void read_maps() {
    if (!json_.contains("maps")) return;
    std::set<std::string> names;
    for (size_t i = 0; i < json_["maps"].size(); ++i) {
      const Json& map = json_["maps"][i];
      const std::string below = fmt::format("/maps/{}", i);
      const std::string name = map["name"];
      if (!names.insert(name).second)
        issue(IssueId::name_taken, below + "/name", fmt::format("expected different names, found {} twice", name));
      Map& read = scale_.maps.emplace_back();
      read.name = name;
      read.channels = map["channels"].get<int>();
      read.source_bits = map["sourceBits"].get<int>();
      read.is_float = map["sourceFloat"].get<bool>();
      read.convention = map["convention"];
      const Json& plane = map["plane"];
      const char* type = name_of(read.source_bits <= 8 ? PixelType::half : PixelType::float32);
      if (plane["type"] != type || plane["channels"].size() != static_cast<size_t>(read.channels))
        issue(IssueId::schema_violation, below + "/plane",
              fmt::format("expected {} channels of type {}, found {} of {}", read.channels, type,
                          plane["channels"].size(), compact_json(plane["type"])));
      add_ref(kMapKey + name, plane, below + "/plane", size_);
    }
  }

  void add_ref(const std::string& key, const Json& plane, const std::string& below, V2i size) {
    refs_.push_back(plane_ref(key, plane, pointer_ + below, size, log_));
  }

  const Json& json_;
  std::string pointer_;
  Manifest& manifest_;
  IssueLog& log_;
  Scale scale_;
  V2i size_{0, 0};
  size_t fragment_count_ = 0;
  PlaneRefs refs_;
};

void read_scales(const Json& json, Manifest& manifest, IssueLog& log) {
  if (json.size() > kMaxManifestScales) return;  // the schema has said so
  std::set<std::string> names;
  for (size_t i = 0; i < json.size(); ++i) {
    const std::string pointer = fmt::format("/scales/{}", i);
    if (log.error_below(pointer)) {
      // An empty scale keeps the numbers of the others.
      manifest.bundle.scales.emplace_back();
      manifest.sizes.emplace_back(0, 0);
      manifest.fragment_counts.push_back(0);
      manifest.refs.emplace_back();
      continue;
    }
    if (!names.insert(json[i]["name"]).second)
      log.add({IssueId::name_taken, {.pointer = pointer + "/name"}, "expected different names, found one twice"});
    ScaleReader(json[i], pointer, manifest, log).read();
  }
  if (!log.error_below("/scales")) check_transfers(manifest.bundle, manifest.sizes, log);
}

void read_provenance(Json& json, Bundle& bundle) {
  for (const Json& source : json["sources"])
    bundle.sources.push_back({source["role"], bytes_of_text(source["name"].get_ref<const std::string&>()),
                              source["sha256"], source["sizeBytes"].get<uint64_t>(), source.value("scale", "")});
  for (Json& stage : json["stages"])
    bundle.stages.push_back({stage["verb"], stage["version"].get<int>(), std::move(stage["parameters"]),
                             std::move(stage["figures"]), stage["input"], stage["output"], stage.value("scale", "")});
}

}  // namespace

Manifest parse_manifest(Json& json, Semantics semantics, IssueLog& log) {
  Manifest manifest;
  check_asset(json, semantics, log);
  if (log.error_count() > 0) return manifest;
  check_schema(json, log);
  const auto root_is_sound = [&](const char* key) {
    return json.contains(key) && !log.error_below(std::string("/") + key);
  };

  manifest.bundle.semantics = json["asset"]["semantics"].get<int>();
  if (json.contains("scales") && json["scales"].is_array()) read_scales(json["scales"], manifest, log);
  if (root_is_sound("noise") && root_is_sound("scales") && !manifest.bundle.scales.empty())
    read_noise(json["noise"], manifest.bundle.scales.back().masks.size(), manifest.bundle.noise.emplace(),
               manifest.noise_refs, log);
  if (root_is_sound("sources") && root_is_sound("stages")) read_provenance(json, manifest.bundle);
  if (root_is_sound("extensions")) manifest.bundle.extensions = std::move(json["extensions"]);
  if (root_is_sound("extras")) manifest.bundle.extras = std::move(json["extras"]);

  const std::set<std::string> known = {"asset",      "generator",          "scales", "noise", "sources", "stages",
                                       "extensions", "extensionsRequired", "extras"};
  for (auto& [key, value] : json.items())
    if (!known.contains(key)) manifest.bundle.unknown[key] = std::move(value);
  warn_unknown_members(json, "", known, log);
  return manifest;
}

}  // namespace texbake
