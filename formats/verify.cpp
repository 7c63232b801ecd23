#include "formats/verify.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/bundle_io.h"
#include "formats/planes.h"
#include "formats/verify_history.h"
#include "formats/verify_noise.h"
#include "formats/verify_scale.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

void warn_stray_files(const fs::path& path, const LoadedBundle& loaded, IssueLog& log) {
  std::set<std::string> known = {kManifestName};
  for (const PlaneRefs& refs : loaded.refs)
    if (!refs.empty()) known.insert(refs[0].file);
  for (const PlaneRefs* refs : {&loaded.noise_refs.spectra, &loaded.noise_refs.tiles})
    if (!refs->empty()) known.insert(refs->at(0).file);
  std::set<std::string> stray;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(path, failed)) stray.insert(entry.path().filename().string());
  for (const std::string& name : stray)
    if (!known.contains(name))
      log.add({IssueId::stray_file, {.file = name}, "expected only files that the manifest names"});
}

void check_scale(const LoadedBundle& loaded, size_t i, IssueLog& log) {
  if (loaded.refs[i].empty()) return;
  const Scale& scale = loaded.bundle.scales[i];
  const ScaleUnderTest test{scale, loaded.sizes[i], fmt::format("/scales/{}", i), loaded.refs[i][0].file,
                            loaded.planes[i]};
  if (scale.colors && test.has("index")) check_palette(test, log);
  if (test.has(kMasksKey)) check_mask_sums(test, log);
  const Json& mean = loaded.manifest["scales"][i]["mean"];
  if (loaded.is_whole(i)) check_means(test, V3f(mean[0].get<float>(), mean[1].get<float>(), mean[2].get<float>()), log);
  check_partitions(test, log);
  if (scale.contents) check_contents(test, log);
}

/// Frees the pixels of a scale that has been judged. What it has, it still seems to have.
void release(Scale& scale) {
  const auto release_partition = [](Partition& partition) { partition = Partition(); };
  scale.exemplar = {};
  if (scale.structure) *scale.structure = {};
  for (Image<float>& mask : scale.masks) mask = {};
  if (scale.colors) scale.colors->index = {}, scale.colors->variation = {};
  if (scale.fragments) release_partition(scale.fragments->partition), scale.fragments->fragments = {};
  if (scale.patches) release_partition(scale.patches->partition);
  if (scale.contents) scale.contents->contents = {};
}

/// One scale after the other is in memory; the finest stays for its noises.
void verify(const fs::path& path, IssueLog& log) {
  const auto judge = [&log](LoadedBundle& loaded, size_t i) {
    check_scale(loaded, i, log);
    check_figures(loaded.bundle, i, log);
    const bool is_finest = i + 1 == loaded.bundle.scales.size();
    if (!is_finest || !loaded.bundle.noise) release(loaded.bundle.scales[i]);
  };
  LoadedBundle loaded = load_bundle(path, {.kept = KeptPlanes::judged, .scale_read = judge}, log);
  if (loaded.refs.empty()) return;
  check_noise(loaded, log);
  check_state(loaded, log);
  check_stages(loaded.bundle, log);
  check_nulls(loaded.bundle, log);
  warn_stray_files(path, loaded, log);
}

}  // namespace

std::vector<Issue> verify_bundle(const fs::path& path) {
  IssueLog log(path.string(), IssueLog::OnError::collect);
  try {
    verify(path, log);
  } catch (const std::exception& error) {
    log.add({IssueId::exr_unreadable,
             {.file = path.string()},
             fmt::format("the checks could not be completed: {}", error.what())});
  }
  return log.issues();
}

}  // namespace texbake
