#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "formats/bundle_io.h"
#include "formats/input_file.h"
#include "formats/json_text.h"
#include "formats/limits.h"
#include "formats/noise_planes.h"
#include "formats/schema.h"
#include "formats/staged_folder.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

Error refusal(const fs::path& path, const std::string& found) {
  return Error(ErrorKind::io, fmt::format("{}: expected a bundle or an unused name to write to, found {}; nothing was "
                                          "changed; choose another output, or remove it first",
                                          path.string(), found));
}

/// One file of planes.
struct Payload {
  PlaneRefs refs;
  std::vector<ScalePlane> planes;
  V2i size{0, 0};  ///< displayWindow

  const std::string& name() const { return refs.at(0).file; }
};

/// Everything of a bundle that is written, before anything is written.
struct Plan {
  std::vector<Payload> payloads;
  std::string manifest;

  bool has_payload(const std::string& name) const {
    return std::ranges::find(payloads, name, &Payload::name) != payloads.end();
  }
};

std::vector<Payload> payloads_of(const Bundle& bundle, const BundleRefs& refs) {
  std::vector<Payload> payloads;
  for (size_t i = 0; i < bundle.scales.size(); ++i)
    payloads.push_back({refs.scales[i], planes_of(bundle.scales[i]), bundle.scales[i].size()});
  if (!bundle.noise) return payloads;
  payloads.push_back({refs.noise.spectra, spectrum_planes(*bundle.noise), spectra_size(*bundle.noise)});
  payloads.push_back({refs.noise.tiles, tile_planes(*bundle.noise), tiles_size(*bundle.noise)});
  return payloads;
}

/// What no reader would take is not written.
void check_size(const std::string& manifest, IssueLog& log) {
  if (manifest.size() > kMaxManifestBytes)
    log.add({IssueId::manifest_too_large,
             {.file = kManifestName},
             fmt::format("expected at most {} bytes, found {}", kMaxManifestBytes, manifest.size())});
  parse_json(manifest, log);
}

Plan make_plan(const Bundle& bundle, const fs::path& path) {
  if (bundle.semantics != kSemantics)
    throw Error(ErrorKind::unsupported, fmt::format("{}: expected semantics {}, found {}; use a newer texbake",
                                                    path.string(), kSemantics, bundle.semantics));
  Plan plan;
  const BundleRefs refs = plane_refs(bundle);
  const Json manifest = manifest_json(bundle, state_json(bundle, refs));
  IssueLog log(path.string(), IssueLog::OnError::throw_first);
  check_schema(manifest, log);
  plan.manifest = print_json(manifest);
  check_size(plan.manifest, log);
  plan.payloads = payloads_of(bundle, refs);
  return plan;
}

bool is_payload_name(const std::string& name) {
  constexpr size_t kTail = sizeof("-0123456789ab.exr") - 1;
  if (name.size() <= kTail || !name.ends_with(".exr") || name[name.size() - kTail] != '-') return false;
  const std::string digits = name.substr(name.size() - kTail + 1, 12);
  return digits.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Does `file` hold, readably, the planes that would be written to it?
bool holds_already(const fs::path& file, const PlaneRefs& refs) {
  std::error_code failed;
  if (!fs::is_regular_file(fs::symlink_status(file, failed))) return false;
  IssueLog log("", IssueLog::OnError::collect);
  const ExrReader reader(file, log);
  if (!reader.is_open()) return false;
  std::vector<std::string> parts;
  for (const PlaneRef& ref : refs) {
    if (!parts.empty() && parts.back() == ref.shape.part) continue;
    parts.push_back(ref.shape.part);
    const auto ignore = [](int, const std::byte*) {};
    if (!reader.holds(ref.shape, log) || reader.read(ref.shape, ignore, log) != ref.pixel_hash) return false;
  }
  return reader.part_names() == parts;
}

/// A file that was not there joins `made`. Its permissions are those of the manifest that stands in the folder.
void write_payload(const Payload& payload, const fs::path& folder, const StepHook& hook, std::vector<fs::path>& made) {
  const fs::path path = folder / payload.name();
  if (holds_already(path, payload.refs)) return;
  std::error_code failed;
  if (!fs::exists(fs::symlink_status(path, failed))) made.push_back(path);
  std::vector<ExrPart> parts;
  for (const ScalePlane& plane : payload.planes)
    if (parts.empty() || parts.back().shape.part != plane.shape.part) parts.push_back(exr_part(plane));
  SafeFile file(path, hook, folder / kManifestName);
  if (hook) hook("write " + payload.name());
  write_exr(file, payload.size, parts);
  file.commit();
}

/// May the manifest in `folder` be that of `plan`?
bool may_be_written(const Plan& plan, const fs::path& folder) {
  std::ifstream stream(folder / kManifestName, std::ios::binary);
  std::string found(plan.manifest.size() + 1, '\0');
  stream.read(found.data(), static_cast<std::streamsize>(found.size()));
  found.resize(static_cast<size_t>(stream.gcount()));
  return stream.bad() || found == plan.manifest;
}

/// Payloads first, the manifest last: until its name appears, the folder is the old bundle or none. When that fails,
/// the payloads that were made for it go again.
void write_files(const Plan& plan, const fs::path& folder, const StepHook& hook) {
  std::vector<fs::path> made;
  try {
    for (const Payload& payload : plan.payloads) write_payload(payload, folder, hook, made);
    SafeFile manifest(folder / kManifestName, hook);
    if (hook) hook(std::string("write ") + kManifestName);
    manifest.write(plan.manifest);
    manifest.commit();
  } catch (...) {
    std::error_code ignored;
    if (!may_be_written(plan, folder))
      for (const fs::path& path : made) fs::remove(path, ignored);
    throw;
  }
}

/// Removes payloads that `plan` does not name, and what killed writers left. Failing to tidy up harms nobody.
void tidy(const fs::path& folder, const Plan& plan, const StepHook& hook) {
  std::vector<fs::path> old;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (is_temporary_name(name) || (is_payload_name(name) && !plan.has_payload(name))) old.push_back(entry.path());
  }
  std::ranges::sort(old);
  for (const fs::path& path : old) {
    if (hook) hook("remove " + path.filename().string());
    fs::remove(path, ignored);
  }
}

void replace_bundle(const Plan& plan, const fs::path& path, const StepHook& hook) {
  const FolderLock lock(path);
  if (!lock) throw refusal(path, "a bundle that another program is writing");
  write_files(plan, path, hook);
  tidy(path, plan, hook);
}

void create_bundle(const Plan& plan, const fs::path& path, const StepHook& hook) {
  StagedFolder staging(path, hook);
  write_files(plan, staging.path(), hook);
  staging.commit();
}

/// Is there a bundle, of whatever version, in the folder? Throws Error(io) where that may not be known.
bool is_bundle(const fs::path& folder) {
  errno = 0;
  std::ifstream stream(folder / kManifestName, std::ios::binary);
  if (!stream && errno == EACCES)
    throw Error(ErrorKind::io, fmt::format("{}: cannot be opened: {}; check its permissions",
                                           (folder / kManifestName).string(), std::strerror(EACCES)));
  std::error_code failed;
  if (!stream || !fs::is_regular_file(folder / kManifestName, failed)) return false;
  IssueLog log("", IssueLog::OnError::collect);
  const Json json = parse_json(file_bytes((folder / kManifestName).string(), kMaxManifestBytes), log);
  return json.is_object() && json.contains("asset") && json["asset"].is_object() &&
         json["asset"].value("kind", Json()) == "texbake.bundle";
}

}  // namespace

void write_bundle(const Bundle& bundle, const fs::path& target, const WriteOptions& options) {
  const fs::path path = with_folder(target);
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(path, failed);
  const bool exists = fs::exists(status);
  if (exists && !fs::is_directory(path, failed)) throw refusal(path, "a file");
  const bool is_new = !exists || (!fs::exists(path / kManifestName, failed) && fs::is_empty(path, failed));
  if (!is_new && !is_bundle(path)) throw refusal(path, "a folder that is not a bundle");
  if (is_new && !fs::is_directory(path.parent_path(), failed))
    throw Error(ErrorKind::io, fmt::format("{}: expected the folder {} to exist, found none; create it first",
                                           path.string(), path.parent_path().string()));
  const Plan plan = make_plan(bundle, path);
  if (is_new)
    create_bundle(plan, path, options.hook);
  else
    replace_bundle(plan, path, options.hook);
}

}  // namespace texbake
