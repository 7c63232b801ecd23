#include "tests/fuzz/sound_bundles.h"

#include <cstring>

#include "formats/history.h"
#include "formats/schema.h"
#include "tests/formats/bundle_fixtures.h"
#include "tests/fuzz/target.h"

namespace texbake::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 16;

Bundle one_scale() {
  Bundle bundle;
  bundle.scales.push_back(scale_with_everything(kSide));
  bundle.sources = {{"color", "rock.jpg", std::string(64, 'a'), 12345}};
  return bundle;
}

Bundle with_history(Bundle bundle) {
  for (const char* verb : {"convert", "decompose", "fragment", "patch", "select-contents"})
    record_stage(bundle, {.verb = verb, .parameters = {{"seed", 1}}});
  return bundle;
}

Bundle two_scales() {
  Bundle bundle = one_scale();
  bundle.scales.push_back(scale_with_everything(kSide, "finer"));
  bundle.scales[1].transfer = ScaleTransfer{.ratio = 2, .weights = {1, 0.5f, 0}};
  bundle.scales[1].soft_border_px = 1;
  return bundle;
}

Bundle of_palette() {
  Bundle bundle = one_scale();
  Scale& scale = bundle.scales[0];
  scale.structure.reset();
  scale.masks.clear();
  scale.maps.clear();
  scale.stores_exemplar = false;
  scale.exemplar = palette_exemplar(*scale.colors);
  Random random(3);
  scale.fragments = square_fragments(scale.exemplar, random);
  return bundle;
}

/// Tiles of noise have 512 texels on a side at least.
Bundle with_noise() {
  Bundle bundle = one_scale();
  Random random(7);
  bundle.noise = two_noises(bundle.scales[0].exemplar, *bundle.scales[0].structure, random);
  return with_history(std::move(bundle));
}

/// The planes of one payload file: what a manifest says of each, and its place in it.
struct Payload {
  std::string stem;
  PlaneRefs refs;
  std::vector<Json*> planes;
};

void add(Payload& payload, const std::string& key, Json& plane, V2i size) {
  IssueLog ignored("", IssueLog::OnError::collect);
  payload.refs.push_back(plane_ref(key, plane, "", size, ignored));
  payload.planes.push_back(&plane);
}

Payload payload_of(Json& scale) {
  Payload payload{scale["name"], {}, {}};
  const V2i size(scale["size"][0].get<int>(), scale["size"][1].get<int>());
  const size_t count = scale.contains("fragments") ? scale["fragments"]["count"].get<size_t>() : 0;
  for (auto& [key, plane] : scale["planes"].items())
    if (plane.is_object() && plane.contains("pixelHash"))
      add(payload, key, plane, key == "fragmentClass" || key == "fragmentColor" ? table_size(count, size) : size);
  if (scale.contains("maps"))
    for (Json& map : scale["maps"]) add(payload, kMapKey, map["plane"], size);
  return payload;
}

std::vector<Payload> payloads_of(Json& json) {
  std::vector<Payload> payloads;
  for (Json& scale : json["scales"]) payloads.push_back(payload_of(scale));
  if (!json.contains("noise")) return payloads;
  Json& noise = json["noise"];
  const int side = noise["tileSize"].get<int>();
  Payload spectra{"spectra", {}, {}}, tiles{"noise", {}, {}};
  for (Json& one : noise["noises"]) {
    const int size = one["spectrumSize"].get<int>();
    add(spectra, "spectrum", one["spectrum"], {size, size});
    add(tiles, "tile", one["tile"], {side, side});
  }
  add(spectra, "histogram", noise["histogram"], {Equalization::kEntries, static_cast<int>(3 * noise["noises"].size())});
  payloads.push_back(std::move(spectra));
  payloads.push_back(std::move(tiles));
  return payloads;
}

/// The hashes of what the file holds, where it holds the planes.
void hash_again(Payload& payload, const fs::path& file) {
  IssueLog log("", IssueLog::OnError::collect);
  const ExrReader reader(file, log);
  if (!reader.is_open()) return;
  for (size_t i = 0; i < payload.refs.size(); ++i) {
    PlaneRef& ref = payload.refs[i];
    if (!reader.holds(ref.shape, log) || !reader.has_room_for({ref.shape}, log)) continue;
    const std::string hash = reader.read(
        ref.shape, [](int, const std::byte*) {}, log);
    if (!hash.empty()) (*payload.planes[i])["pixelHash"] = ref.pixel_hash = hash;
  }
}

void repair_stages(Json& json) {
  std::vector<SourceFile> sources;
  for (const Json& source : json["sources"])
    sources.push_back({source["role"], source["name"], source["sha256"], 0, source.value("scale", "")});
  std::vector<Stage> stages;
  for (const Json& stage : json["stages"]) stages.push_back({.verb = stage["verb"], .scale = stage.value("scale", "")});
  const Json scales = history_json({json["scales"], json.value("noise", Json())});
  HistoryHashes hashes(scales, sources, stages);
  for (size_t i = 0; i < stages.size(); ++i) {
    json["stages"][i]["input"] = hashes.input(i);
    json["stages"][i]["output"] = hashes.output(i);
  }
}

bool follows_schema(const Json& json) {
  IssueLog log("", IssueLog::OnError::collect);
  check_schema(json, log);
  return log.error_count() == 0;
}

}  // namespace

std::vector<Bundle> sound_bundles() {
  std::vector<Bundle> bundles;
  bundles.push_back(with_history(one_scale()));
  bundles.push_back(two_scales());
  bundles.push_back(of_palette());
  bundles.push_back(with_noise());
  return bundles;
}

std::string packed(const Files& files) {
  std::string bytes;
  const auto append = [&](const std::string& text) {
    const auto size = static_cast<uint32_t>(text.size());
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes += text;
  };
  for (const auto& [name, text] : files) append(name), append(text);
  return bytes;
}

Files unpacked(std::string_view bytes) {
  Files files;
  const auto take = [&] {
    uint32_t size = 0;
    if (bytes.size() < sizeof size) return bytes = {}, std::string();
    std::memcpy(&size, bytes.data(), sizeof size);
    bytes.remove_prefix(sizeof size);
    std::string text(bytes.substr(0, size));
    bytes.remove_prefix(text.size());
    return text;
  };
  while (!bytes.empty() && files.size() < 16) {
    std::string name = take();
    const bool is_plain = !name.empty() && name.size() < 100 && name.find_first_of(std::string("/\0", 2)) == name.npos;
    if (!is_plain || name == "." || name == "..") name = "other";
    files[name] = take();
  }
  return files;
}

Files files_of(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().filename().string()] = read_file(entry.path());
  return files;
}

void write_files(const Files& files, const fs::path& folder) {
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(folder))
    if (!files.contains(entry.path().filename().string())) fs::remove(entry.path());
  for (const auto& [name, text] : files) write_file(folder / name, text);
}

void repair(Json& json, Files& files, Repair what) {
  if (!follows_schema(json)) return;
  for (Payload& payload : payloads_of(json)) {
    if (payload.refs.empty()) continue;
    const std::string before = payload.refs[0].file;
    if (!files.contains(before)) continue;
    if (what == Repair::hashes) {
      write_file(scratch() / "payload.exr", files[before]);
      hash_again(payload, scratch() / "payload.exr");
    }
    const std::string name = payload_name(payload.stem, payload.refs);
    for (Json* plane : payload.planes) (*plane)["file"] = name;
    if (name == before) continue;
    files[name] = std::move(files[before]);
    files.erase(before);
  }
  repair_stages(json);
}

}  // namespace texbake::fuzz
